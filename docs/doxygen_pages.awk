# Doxygen's input filter for pages: links between them, and to a heading of one, lead to the same place on the
# site as on a file host. A page is known by its path, docs/guide/scene.md as guide_scene, a heading by its page
# and its words. The guide's list of pages becomes the tree of the site. What is no page is opened where it
# stands, as seen from build/docs/html. A comment that names a file of build/docs stands for its text.
BEGIN { guide = "docs/guide/README.md" }
function id_of(path) {
  sub(/^docs\//, "", path)
  sub(/\.md$/, "", path)
  gsub(/[^A-Za-z0-9]/, "_", path)
  return tolower(path)
}
function anchor(words) {
  words = tolower(words)
  gsub(/[^a-z0-9 _-]/, "", words)
  gsub(/[ -]/, "_", words)
  return words
}
# Without a/.. in it.
function plain(path) {
  while (sub(/[^\/]+\/\.\.\//, "", path));
  return path
}
function link(text, target,    path, heading) {
  path = heading = target
  sub(/#.*/, "", path)
  if (!sub(/^[^#]*#/, "", heading)) heading = ""
  if (target ~ /^[a-z]+:/) return "[" text "](" target ")"
  if (path ~ /\.(svg|png)$/) {
    sub(/^.*\//, "", path)
    return "[" text "](" path ")"
  }
  path = path == "" ? page : plain(folder path)
  if (path ~ /\.hpp$/ && sub(/^include\//, "", path)) return "[" text "](@ref " path ")"
  if (path !~ /\.md$/) return "[" text "](../../../" path ")"
  if (heading != "") return "[" text "](@ref " id_of(path) "_" anchor(heading) ")"
  return page == guide ? "@subpage " id_of(path) " \"" text "\"" : "[" text "](@ref " id_of(path) ")"
}
FNR == 1 {
  page = FILENAME
  sub(/^.*\/docs\//, "docs/", page)
  sub(/^\/.*\//, "", page)
  folder = page
  sub(/[^\/]*$/, "", folder)
}
/^<!-- build\/docs\/.* -->$/ {
  while ((getline text < $2) > 0) print text
  next
}
/^```/ { code = !code }
code || /^```/ { print; next }
/^#+ / {
  words = $0
  sub(/^#+ /, "", words)
  print $0 " {#" id_of(page) ($1 == "#" ? "" : "_" anchor(words)) "}"
  next
}
/^\[[^]]*\]: / {
  sub(/: .*\/include\//, ": @ref ")
  print
  next
}
{
  line = ""
  for (rest = $0; match(rest, /\[[^][]*\]\([^)]*\)/); rest = substr(rest, RSTART + RLENGTH)) {
    found = substr(rest, RSTART + 1, RLENGTH - 2)
    middle = index(found, "](")
    line = line substr(rest, 1, RSTART - 1) link(substr(found, 1, middle - 1), substr(found, middle + 2))
  }
  print line rest
}
