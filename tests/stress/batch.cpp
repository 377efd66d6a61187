// Batches of every shipped mechanism: 1e5 states of each, 1e6 in a full run.
#include "effort.hpp"

namespace {
const auto rounds = static_cast<unsigned>(stress::effort(25, 250));
}
#include "../unit/control/batch_suite.hpp"
