"""The site of the documentation, by Sphinx; script/docs puts its pages together and calls it."""
project = "Leadscrew"
author = "Leadscrew"
extensions = ["myst_parser"]
myst_enable_extensions = ["deflist"]
myst_heading_anchors = 4
exclude_patterns = []
highlight_language = "none"
pygments_style = "tango"
pygments_dark_style = "native"
smartquotes = False
html_title = "Leadscrew"
html_theme = "furo"
html_static_path = ["style.css"]
html_css_files = ["style.css"]
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#0b5ea8", "color-brand-content": "#0b5ea8"},
    "dark_css_variables": {"color-brand-primary": "#6db6ff", "color-brand-content": "#6db6ff"},
}
# Blocks of these languages are shown as they are: no lexer knows them.
suppress_warnings = ["misc.highlighting_failure"]


def setup(app):
    from pygments.lexers.special import TextLexer
    for language in ("ngc", "tbl", "var"):
        app.add_lexer(language, TextLexer)
