"""A hook of MkDocs. Pages link to files beside docs/, which a site does not have: there the words stand without the link, or with
one to `repo_url` of mkdocs.yml if that is set."""

import re

OUTSIDE = re.compile(r"!?\[([^\]]+)\]\(\.\./([^)]+)\)")


def on_page_markdown(markdown, config, **_):
    host = (config.get("repo_url") or "").rstrip("/")
    return OUTSIDE.sub(rf"[\1]({host}/blob/main/\2)" if host else r"\1", markdown)
