# Doxygen's input filter for pages: links between them, and to a heading of one, lead to the same place on the
# site as on a code host. A page is known by its path, docs/guide/scene.md as guide_scene, a heading by its page
# and its words. The guide's list of pages becomes the tree of the site. Another
# file of the repository has a page of its own, made by build.sh. A comment that names a file of build/docs stands for its text.
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
  gsub(/`/, "", text)  # Doxygen prints the backticks of a reference
  if (path ~ /\.hpp$/ && sub(/^include\//, "", path)) return "[" text "](@ref " path ")"
  if (path !~ /\.md$/) return "[" text "](@ref " id_of(path) ")"
  if (heading != "") return "[" text "](@ref " id_of(path) "_" anchor(heading) ")"
  return page == guide && !listed[path]++ ? "@subpage " id_of(path) " \"" text "\"" : "[" text "](@ref " id_of(path) ")"
}
# Of references like [`text`][name].
function without_backticks(s,    done, text) {
  while (match(s, /\[`[^`]*`\]\[/)) {
    text = substr(s, RSTART, RLENGTH)
    gsub(/`/, "", text)
    done = done substr(s, 1, RSTART - 1) text
    s = substr(s, RSTART + RLENGTH)
  }
  return done s
}
# Around code with an apostrophe.
function with_doubled_backticks(s,    done, code) {
  while (match(s, /`+[^`]*`+/)) {
    code = substr(s, RSTART, RLENGTH)
    if (code ~ /'/ && code !~ /``/) code = "`" code "`"
    done = done substr(s, 1, RSTART - 1) code
    s = substr(s, RSTART + RLENGTH)
  }
  return done s
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
# Formulas as a code host has them, ```math and $`...`$, as Doxygen has them.
/^```math$/ { math = 1; print "@f["; next }
math {
  if (/^```$/) { math = 0; print "@f]" } else print
  next
}
/^```/ { code = !code }
code || /^```/ { print; next }
# Doxygen prints the backticks of a reference, and takes an apostrophe for the end of code between single ones.
{
  $0 = without_backticks(with_doubled_backticks($0))
  while (match($0, /\$`[^`]*`\$/))
    $0 = substr($0, 1, RSTART - 1) "@f$" substr($0, RSTART + 2, RLENGTH - 4) "@f$" substr($0, RSTART + RLENGTH)
}
/^#+ / {
  words = $0
  sub(/^#+ /, "", words)
  print $0 " {#" id_of(page) ($1 == "#" ? "" : "_" anchor(words)) "}"
  if ($1 == "#") print "\n[TOC]\n"
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
