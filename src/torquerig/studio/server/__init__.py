"""The page of the studio: its address, who may open it, its frame, and what its steps are made of.

=============== ==========================================================================================
``start``       a free port, the lock of the folder, the address with its token, the server
``guard``       requests without the token are refused
``compute``     a second process that computes, so that the page answers meanwhile
``warm_up``     what that process does first
``tab``         what one browser tab works on; two tabs share nothing
``tabs``        all tabs of a studio, also those that were loaded again
``step``        one of the six steps
``frame``       the page: files, undo, save, the steps, what is wrong
``save_as``     the open file under another name
``elements``    headings, paragraphs, buttons, tables
``fields``      fields of a form, each with its problem under it
``plot``        a Bokeh plot whose curves are sent and redrawn
``page/``       style sheet and scripts of the page
=============== ==========================================================================================

Uses NiceGUI, which the extra ``studio`` installs.
"""
