// Batches of every shipped mechanism: 1e5 states of each, 1e6 in a full run. CMake compiles this file twice:
// for the target as it is, where all bits are those of single cycles, and with -mavx2 -mfma, where numbers
// may differ by roundings.
#include "effort.hpp"

namespace {
const auto rounds = static_cast<unsigned>(stress::effort(25, 250));
}
#include "../unit/control/batch_suite.hpp"
