# Every section of every page, as one script for site_search.js: a script loads from file://, JSON does not.
# awk -f search_index.awk docs/*.md docs/guide/*.md > search_index.js
function id_of(path) { sub(/^docs\//, "", path); sub(/\.md$/, "", path); gsub(/[^A-Za-z0-9]/, "_", path); return tolower(path) }
function anchor(words) { words = tolower(words); gsub(/[^a-z0-9 _-]/, "", words); gsub(/[ -]/, "_", words); return words }
function flush() { if (title != "") printf "[\"%s\",\"%s\",\"%s\",\"%s\"],\n", url, page_title, title, text; text = "" }
function plain(s) { gsub(/\]\([^)]*\)/, "", s); gsub(/[`*\[\]|"\\]/, " ", s); gsub(/[ \t]+/, " ", s); return s }
BEGIN { print "const site_sections = [" }
FNR == 1 { flush(); title = ""; code = 0; page = id_of(FILENAME); file = page == "start" ? "index" : page }
/^```/ { code = !code; next }
/^<!--/ { next }
!code && /^#+ / { flush(); words = $0; sub(/^#+ /, "", words); title = plain(words)
  if ($1 == "#") { page_title = title; url = file ".html" } else url = file ".html#" page "_" anchor(words); next }
# Each word of the glossary is a section of its own
page == "glossary" && /^\| [^-]/ && $0 !~ /^\| Word \|/ { split($0, cells, / *\| */)
  printf "[\"%s\",\"%s\",\"%s\",\"%s\"],\n", url, page_title, plain(cells[2]), plain(cells[3]); next }
# Each question is a section of its own
/^\| [^|]*\? \| / { split($0, cells, / *\| */)
  printf "[\"%s\",\"%s\",\"%s\",\"%s\"],\n", url, page_title, plain(cells[2]), plain(cells[3]); next }
{ text = text " " plain($0) }
END { flush(); print "];" }
