#include "laws.hpp"

namespace explorer {

law_kind law_of(const std::string& id) {
  std::string known;
  for (const law_description& l : laws) {
    if (id == l.id) return l.kind;
    known.append(known.empty() ? "one of " : ", ").append(l.id);
  }
  refuse("law", id, known);
}

const char* id_of(law_kind kind) {
  for (const law_description& l : laws)
    if (l.kind == kind) return l.id;
  return "";
}

}  // namespace explorer
