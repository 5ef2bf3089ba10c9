"""What is seen: recordings, their files, the stages that change them, and the lines that stand in them."""
