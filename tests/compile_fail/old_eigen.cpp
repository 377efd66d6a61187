// expect: passive_haptics needs Eigen 3.4 or newer: this file includes an older one
#include <Eigen/Core>
#undef EIGEN_MAJOR_VERSION
#define EIGEN_MAJOR_VERSION 3
#include <passive_haptics/passive_haptics.hpp>
