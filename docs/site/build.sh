#!/usr/bin/env bash
# Makes the site, build/docs/html/index.html, from the folder of the repository. It needs no server.
# Needs python3 and Debian's doxygen doxygen-awesome-css libjs-katex fonts-katex.
set -eu
unset CDPATH
cd "$(dirname "$0")/../.."
parts=build/docs html=build/docs/html
mkdir -p $parts
rm -rf $html
# A page for each file to which a page links, so that its readers stay within the site
grep -ohE '\]\([^)#]+\.(cpp|hpp|py|sh|toml|txt|csv)\)' docs/*.md docs/guide/*.md | sed -E 's#\]\((\.\./)*([^)]*)\)#\2#; s#^[^/]*$#docs/guide/&#' |
  grep -v '^include/' | sort -u | while read -r file; do
    id=${file#docs/}
    printf '/** @page %s %s\n@include %s\n*/\n' "$(tr -c 'A-Za-z0-9\n' _ <<<"${id,,}")" "$file" "$file"
  done >$parts/files.dox
# The page of the Python reference, to which python.md leads
mkdir -p $parts/guide
python3 docs/site/python_reference.py >$parts/python_reference.md
cat >$parts/guide/python_reference.md <<'END'
# Python reference

The texts of `help()`, for all public names. Arrays are NumPy's, of `float64`: `Numbers` is anything that NumPy makes a vector of,
such as a list, `Rows` anything that it makes a matrix of, and an `Array` is returned.

<!-- build/docs/python_reference.md -->
END
echo 'All names: @subpage guide_python_reference "Python reference".' >$parts/python_reference_link.md
: >$parts/search_index.js
doxygen docs/site/Doxyfile
# Doxygen does not report a reference of the layout that leads nowhere
for id in $(grep -o '@ref [a-z0-9_]*' docs/site/layout.xml | cut -d' ' -f2); do
  [[ -e $html/$id.html ]] || { echo "docs/site/layout.xml: there is no page $id" >&2; exit 1; }
done
# Doxygen links to the list of nested classes also where all of them are private
for page in $html/*.html; do
  grep -q 'name="nested-classes"' "$page" || sed -i 's|<a href="#nested-classes">[^<]*</a> &#124;||' "$page"
done
# What is searched: pages by section, then the classes and concepts that Doxygen lists for its own search, then what
# there is for Python
{
  awk -f docs/site/search_index.awk docs/*.md docs/guide/*.md | sed '$d'
  sed -nE "s/^  \['[^']*',\['([^']*)',\['\.\.\/([^']*)'.*/[\"\2\",\"Reference\",\"\1\",\"\"],/p" $html/search/{classes,concepts}_*.js
  python3 docs/site/python_reference.py --index
  echo '];'
} >$html/search_index.js
(cd $html && awk -f ../../../docs/site/links.awk *.html) ||
  { echo "links of the site that lead nowhere are listed above: mend them in docs/" >&2; exit 1; }
# The landing page opens with the explorer if it was built (./examples/run explorer)
page=build/output/explorer/explorer.html
if [[ -e $page ]]; then
  cp $page $html/
  sed -i -E 's#href="guide_explorer\.html"#href="explorer.html"#; s#<img src="explorer\.png"[^>]*>#<a href="explorer.html">&</a>#' $html/index.html
  [[ $(grep -o 'href="explorer\.html"' $html/index.html | wc -l) == 2 ]] || { echo "docs/start.md does not open with the explorer" >&2; exit 1; }
fi
mkdir $html/fonts
cp -L /usr/share/javascript/katex/fonts/*.woff2 $html/fonts/
