// compare EXPECTED ACTUAL [IN_DOUBLE IN_FLOAT]: whether two outputs of golden are the same; with two bounds,
// whether their numbers are as near, relative to 1 or to the number if that is larger. Words and whole
// numbers must be the same.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream from(line);
  std::vector<std::string> words;
  for (std::string word; from >> word;) words.push_back(word);
  return words;
}

// Whether it is a real number, in hexadecimal
bool is_real(const std::string& word) { return word.find('x') != word.npos || word == "nan"; }

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 5) return 2;
  std::ifstream expected(argv[1]), actual(argv[2]);
  const bool exactly = argc == 3;
  const double bounds[] = {exactly ? 0 : std::atof(argv[3]), exactly ? 0 : std::atof(argv[4])};
  int lines = 0, wrong = 0;
  double worst[] = {0, 0};
  for (std::string given, line; std::getline(expected, given); ++lines) {
    std::getline(actual, line);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const auto a = words_of(given), b = words_of(line);
    bool same = a.size() == b.size() && a.size() > 2;
    const int is_float = a.size() > 2 && a[1] == "1" ? 1 : 0;
    for (std::size_t i = 0; same && i < a.size(); ++i) {
      if (a[i] == b[i]) continue;
      const double x = std::strtod(a[i].c_str(), nullptr), y = std::strtod(b[i].c_str(), nullptr);
      const double apart = std::abs(y - x) / std::max(1.0, std::abs(x));
      same = !exactly && is_real(a[i]) && is_real(b[i]) && apart <= bounds[is_float];
      if (same) worst[is_float] = std::max(worst[is_float], apart);
    }
    if (same || ++wrong > 3) continue;
    std::cout << "line " << lines + 1 << "\n  expected " << given << "\n  actual   " << line << "\n";
  }
  std::string more;
  if (std::getline(actual, more)) ++wrong;
  std::cout << lines << " lines, " << wrong << " wrong";
  if (!exactly)
    std::cout << ", the others within " << worst[0] << " in double and " << worst[1] << " in float";
  std::cout << "\n";
  return lines > 0 && wrong == 0 ? 0 : 1;
}
