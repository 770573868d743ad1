#include "updating/structure/cards/card_reader.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"

#include <fmt/format.h>

#include <limits>

namespace tapfit::structure {
namespace {

// A field as a message quotes it: long ones, of files that are no deck, in
// part.
std::string quoted(const std::string& text) {
  constexpr std::size_t most = 40;
  if (text.size() <= most) return text;
  return text.substr(0, most) + "...";
}

}  // namespace

std::size_t CardReader::size() const {
  std::size_t count = card_.fields.size();
  while (count > 0 && card_.fields[count - 1].empty()) --count;
  return count;
}

bool CardReader::blank(std::size_t field) const { return text(field).empty(); }

const std::string& CardReader::text(std::size_t field) const {
  static const std::string no_text;
  return field < card_.fields.size() ? card_.fields[field] : no_text;
}

int CardReader::integer(std::size_t field, const char* meaning) const {
  const std::optional<int> value = parse_integer(text(field));
  if (!value) {
    fail(fmt::format("field {} ({}) is \"{}\", an integer of at most {} "
                     "is needed",
                     field + 1,
                     meaning,
                     quoted(text(field)),
                     std::numeric_limits<int>::max()),
         "Correct the field.");
  }
  return *value;
}

int CardReader::integer_or(std::size_t field,
                           int fallback,
                           const char* meaning) const {
  return blank(field) ? fallback : integer(field, meaning);
}

int CardReader::id(std::size_t field, const char* meaning) const {
  const int value = integer(field, meaning);
  if (value <= 0) {
    fail(fmt::format("field {} ({}) is {}, ids are above zero",
                     field + 1,
                     meaning,
                     value),
         "Correct the field.");
  }
  return value;
}

std::pair<int, int> CardReader::range(std::size_t thru,
                                      const char* meaning) const {
  const int from = id(thru - 1, meaning);
  const int to = id(thru + 1, meaning);
  if (to < from) {
    fail(fmt::format("{} THRU {} runs backwards and names nothing", from, to),
         "Put the smaller id first.");
  }
  return {from, to};
}

double CardReader::real(std::size_t field, const char* meaning) const {
  const std::optional<double> value = parse_real(text(field));
  if (!value) {
    fail(fmt::format("field {} ({}) is \"{}\", a number is needed",
                     field + 1,
                     meaning,
                     quoted(text(field))),
         "Correct the field.");
  }
  return *value;
}

double CardReader::real_or(std::size_t field,
                           double fallback,
                           const char* meaning) const {
  return blank(field) ? fallback : real(field, meaning);
}

Eigen::Vector3d CardReader::vector(std::size_t first,
                                   const char* meaning) const {
  return {real_or(first, 0.0, meaning),
          real_or(first + 1, 0.0, meaning),
          real_or(first + 2, 0.0, meaning)};
}

std::string CardReader::components(std::size_t field) const {
  std::string digits;
  for (const char c : text(field)) {
    if (c == '0' || c == ' ') continue;
    if (c < '1' || c > '6') {
      fail(fmt::format("field {} (components) is \"{}\", digits 1 to 6 are "
                       "needed",
                       field + 1,
                       quoted(text(field))),
           "Correct the field.");
    }
    digits += c;
  }
  return digits;
}

std::string CardReader::where() const {
  return trimmed(fmt::format("{} {} {}", card_.where, card_.name(), text(1)));
}

void CardReader::fail(const std::string& what,
                      const std::string& remedy) const {
  throw InputError(what, where(), remedy);
}

}  // namespace tapfit::structure
