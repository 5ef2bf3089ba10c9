"""The Excel workbooks of a study and of a matrix; the same input gives the same bytes."""
