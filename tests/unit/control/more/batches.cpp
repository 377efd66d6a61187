// Batches of every shipped mechanism: 2e4 states of each.
namespace {
constexpr unsigned rounds = 1;
}
#include "../batch_suite.hpp"
