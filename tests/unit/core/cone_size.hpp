// How large a projection is.
#pragma once

// Half-spaces { p : B^T p <= 0 } by the columns of B.
template <class Scalar, int Rows, int Columns>
struct size {
  using T = Scalar;
  static constexpr int rows = Rows, columns = Columns;
};
