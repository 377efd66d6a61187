# Doxygen's input filter: what stands in namespace passive_haptics belongs to the group of its folder, so
# scene/mesh/proxy.hpp to scene_mesh. groups.dox names the groups. Lines keep their numbers.
FNR == 1 {
  group = FILENAME
  if (!sub(/^.*include\/passive_haptics\//, "", group) || !sub(/\/[^\/]*$/, "", group)) group = ""
  gsub(/\//, "_", group)
}
# A dot product would end the brief description.
/\/\/\// { gsub(/ \. /, " · ") }
group && /^namespace passive_haptics(::testing)? \{$/ { $0 = $0 " /** @addtogroup " group " */ /** @{ */" }
group && /^\}  \/\/ namespace passive_haptics(::testing)?$/ { $0 = "/** @} */ " $0 }
{ print }
