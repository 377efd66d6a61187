# Links of the site that lead nowhere, one a line; ends with 1 if there are any. In the folder of the site:
# awk -f links.awk *.html. Links to addresses and to files of the repository are left out.
function each(line, attribute,    found, rest) {
  rest = line
  while (match(rest, attribute "=\"[^\"]*\"")) {
    found = substr(rest, RSTART + length(attribute) + 2, RLENGTH - length(attribute) - 3)
    rest = substr(rest, RSTART + RLENGTH)
    if (attribute == "href") {
      gsub(/&amp;/, "\\&", found)
      if (found !~ /^([a-z]+:|#?$|\.\.\/)/) link[FILENAME "\t" found] = 1
    } else {
      place[FILENAME "#" found] = 1
    }
  }
}
FNR == 1 { page[FILENAME] = 1 }
/<a / { each($0, "href") }
/ id="/ { each($0, "id") }
/ name="/ { each($0, "name") }
END {
  for (one in link) {
    split(one, part, "\t")
    to = part[2]
    if (to ~ /^#/) to = part[1] to
    file = to
    sub(/#.*/, "", file)
    if (file !~ /\.html$/) continue
    if (!(file in page) || (to ~ /#/ && !(to in place))) { print part[1] ": " part[2]; ++bad }
  }
  exit bad > 0
}
