"""What one tab of the studio works on: files of one folder, edited by key, checked, undone, saved.

tab_session        the files that one tab has open; two sessions share nothing
working_document   one open file: text, problems, last good result, undo and redo
checked            a text checked as what it is: scenario, sidecar, matrix, filter chains
problem            what is wrong, by field and part
file_on_disk       the file as it was read; whether it has changed since; writing
folder_files       what is in the folder
catalog_state      the catalog, read again where its files change; the last good one stays
studio_lock        one studio per folder

yaml_edits         edits of a YAML text by key path; every other sign stays
yaml_places        an entry replaced, inserted, removed, moved    yaml_spans  where entries begin and end
yaml_values        values as YAML text
"""
