# Doxygen's input filter: what stands in namespace passive_haptics belongs to the group of its folder, so
# scene/mesh/proxy.hpp to scene_mesh. groups.dox names the groups. Lines keep their numbers.
FNR == 1 {
  group = FILENAME
  if (!sub(/^.*include\/passive_haptics\//, "", group) || !sub(/\/[^\/]*$/, "", group)) group = ""
  gsub(/\//, "_", group)
}
# The first comment of a header is about the file, and members() is the same table everywhere
FNR == 1 && /^\/\/\/ / && !/@file/ { sub(/^\/\/\/ /, "/// @file " substr(FILENAME, match(FILENAME, /include\//)) " ") }
/static constexpr auto members\(\)/ && before !~ /^ *\/\/\// { sub(/static/, "/** The table of core/parameters.hpp. */ static") }
{ before = $0 }
# A dot product, or the number of a figure, does not end a brief description.
/\/\/\// {
  gsub(/ \. /, " · ")
  gsub(/Fig\. /, "Fig.\\\\ ")
  gsub(/Figs\. /, "Figs.\\\\ ")
}
# The name of a function in brackets, where a macro has the same name
/^constexpr T\([a-z]+\)\(/ { sub(/T\(/, "T "); sub(/\)\(/, "(") }
group && /^namespace passive_haptics(::testing)? \{$/ { $0 = $0 " /** @addtogroup " group " */ /** @{ */" }
group && /^\}  \/\/ namespace passive_haptics(::testing)?$/ { $0 = "/** @} */ " $0 }
{ print }
