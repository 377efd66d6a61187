// slow
// Batches of every shipped mechanism: 4e3 states of each.
namespace {
constexpr unsigned rounds = 1;
}
#include "batch_suite.hpp"
