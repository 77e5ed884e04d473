# Citations of pages have anchors, which Doxygen would take for links of its own.
s|(docs/[a-z0-9_/]+[.]md)#[a-z0-9-]+|\1|g
