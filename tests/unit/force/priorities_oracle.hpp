// Least squares with priorities and bounds, by trying every face of the box, in a wider type.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace oracle {

template <class Real>
using list = std::vector<Real>;

// Rows A and targets b of one level of priority.
template <class Real>
struct level {
  std::vector<list<Real>> rows;
  list<Real> targets;
};

template <class Real>
Real inner(const list<Real>& a, const list<Real>& b) {
  Real sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

template <class Real>
Real length(const list<Real>& a) {
  using std::sqrt;
  return sqrt(inner(a, a));
}

template <class Real>
void take_out(const list<Real>& axis, list<Real>& v) {
  const Real along = inner(axis, v);
  for (std::size_t i = 0; i < v.size(); ++i) v[i] -= along * axis[i];
}

// Adds v to an orthonormal basis unless it depends on it.
template <class Real>
bool extend(std::vector<list<Real>>& basis, list<Real> v, Real tolerance) {
  const Real before = length(v);
  for (int pass = 0; pass < 3; ++pass) {
    for (const auto& axis : basis) take_out(axis, v);
  }
  const Real rest = length(v);
  if (!(rest > tolerance * before) || before == 0) return false;
  for (auto& x : v) x /= rest;
  basis.push_back(v);
  return true;
}

// Least |A x - b| over x = x0 + span(basis): x0 moves there, the basis keeps what A does not see.
template <class Real>
void settle(const level<Real>& l, list<Real>& x, std::vector<list<Real>>& basis, Real tolerance) {
  const std::size_t n = x.size();
  std::vector<list<Real>> seen, unseen;  // images A d, orthonormalised, with the d that make them
  std::vector<list<Real>> directions;
  Real size = 0;
  for (const auto& row : l.rows) size += inner(row, row);
  using std::sqrt;
  size = sqrt(size);
  // Pivoted: the direction with the largest image goes first.
  std::vector<list<Real>> rest = basis;
  while (!rest.empty()) {
    std::size_t best = 0;
    Real largest = -1;
    std::vector<list<Real>> images;
    for (std::size_t k = 0; k < rest.size(); ++k) {
      list<Real> image;
      for (const auto& row : l.rows) image.push_back(inner(row, rest[k]));
      for (int pass = 0; pass < 2; ++pass) {
        for (std::size_t s = 0; s < seen.size(); ++s) {
          const Real along = inner(seen[s], image);
          for (std::size_t i = 0; i < image.size(); ++i) image[i] -= along * seen[s][i];
          for (std::size_t i = 0; i < n; ++i) rest[k][i] -= along * directions[s][i];
        }
      }
      images.push_back(image);
      if (length(image) > largest) {
        largest = length(image);
        best = k;
      }
    }
    if (!(largest > tolerance * size)) break;
    list<Real> image = images[best], direction = rest[best];
    for (auto& v : image) v /= largest;
    for (auto& v : direction) v /= largest;
    seen.push_back(image);
    directions.push_back(direction);
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(best));
  }
  list<Real> missing = l.targets;
  for (std::size_t i = 0; i < missing.size(); ++i) missing[i] -= inner(l.rows[i], x);
  for (std::size_t s = 0; s < seen.size(); ++s) {
    const Real along = inner(seen[s], missing);
    for (std::size_t i = 0; i < n; ++i) x[i] += along * directions[s][i];
  }
  for (auto& v : rest) extend(unseen, v, tolerance);
  basis = unseen;
}

// |A x - b| of each level.
template <class Real>
list<Real> costs(const std::vector<level<Real>>& levels, const list<Real>& x) {
  list<Real> all;
  for (const auto& l : levels) {
    list<Real> missing = l.targets;
    for (std::size_t i = 0; i < missing.size(); ++i) missing[i] -= inner(l.rows[i], x);
    all.push_back(length(missing));
  }
  return all;
}

// The best of all faces' best points. Costs that differ by less than `tie` (relative to `scale` of the level)
// tie.
template <class Real>
list<Real> solve_by_faces(const std::vector<level<Real>>& levels, const list<Real>& lower,
                          const list<Real>& upper, Real tie) {
  const std::size_t n = lower.size();
  std::size_t faces = 1;
  for (std::size_t i = 0; i < n; ++i) faces *= 3;
  list<Real> best, best_costs;
  for (std::size_t face = 0; face < faces; ++face) {
    list<Real> x(n, Real(0));
    std::vector<list<Real>> basis;
    std::size_t code = face;
    bool possible = true;
    for (std::size_t i = 0; i < n; ++i, code /= 3) {
      if (code % 3 == 2) {
        basis.emplace_back(n, Real(0));
        basis.back()[i] = 1;
      } else {
        x[i] = code % 3 == 0 ? lower[i] : upper[i];
        possible = possible && x[i] > Real(-1e30) && x[i] < Real(1e30);
      }
    }
    if (!possible) continue;
    for (const auto& l : levels) settle(l, x, basis, tie);
    for (std::size_t i = 0; i < n; ++i) {
      const Real slack = tie * (1 + length(x));
      possible = possible && x[i] >= lower[i] - slack && x[i] <= upper[i] + slack;
    }
    if (!possible) continue;
    const list<Real> here = costs(levels, x);
    bool better = best.empty();
    for (std::size_t k = 0; k < here.size() && !best.empty(); ++k) {
      const Real slack = tie * (1 + length(levels[k].targets) + best_costs[k]);
      if (here[k] < best_costs[k] - slack) {
        better = true;
        break;
      }
      if (here[k] > best_costs[k] + slack) break;
    }
    if (better) {
      best = x;
      best_costs = here;
    }
  }
  return best;
}

}  // namespace oracle
