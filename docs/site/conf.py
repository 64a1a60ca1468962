# SPDX-License-Identifier: MIT
"""How Sphinx makes the site: see ``docs/make_site.py``."""

import os

project = "pycnc"
author = "the authors of pycnc"
extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
source_suffix = {".md": "markdown"}
root_doc = "index"
exclude_patterns = ["build", ".venv"]
html_theme = "alabaster"
html_theme_options = {"fixed_sidebar": True, "page_width": "1100px"}
myst_heading_anchors = 4
autodoc_member_order = "bysource"
autodoc_typehints = "none"
breathe_projects = {"nck": os.environ["PYCNC_DOXYGEN"]}
breathe_default_project = "nck"
breathe_domain_by_extension = {"h": "c"}
# A struct's tag and a function may have one name in C.
suppress_warnings = ["duplicate_declaration.c"]
