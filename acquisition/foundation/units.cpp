#include "acquisition/foundation/units.hpp"

#include <array>

namespace tapfit::acquisition {
namespace {

struct Entry {
  std::string_view text;
  Quantity quantity;
  double si;
};

constexpr double standard_gravity = 9.80665;     // m/s^2, CGPM 1901
constexpr double pound_force = 4.4482216152605;  // N, exact
constexpr double inch = 0.0254;                  // m, exact
constexpr auto force = Quantity::Force;
constexpr auto acceleration = Quantity::Acceleration;
constexpr auto velocity = Quantity::Velocity;
constexpr auto displacement = Quantity::Displacement;

constexpr auto table = std::to_array<Entry>({
    {"N", force, 1.0},
    {"mN", force, 1e-3},
    {"daN", force, 10.0},
    {"kN", force, 1e3},
    {"MN", force, 1e6},
    {"lbf", force, pound_force},
    {"lb", force, pound_force},
    {"ozf", force, pound_force / 16.0},
    {"kip", force, 1e3 * pound_force},
    {"kgf", force, standard_gravity},
    {"dyn", force, 1e-5},
    {"m/s^2", acceleration, 1.0},
    {"g", acceleration, standard_gravity},
    {"gn", acceleration, standard_gravity},
    {"mg", acceleration, 1e-3 * standard_gravity},
    {"ug", acceleration, 1e-6 * standard_gravity},
    {"um/s^2", acceleration, 1e-6},
    {"mm/s^2", acceleration, 1e-3},
    {"cm/s^2", acceleration, 1e-2},
    {"Gal", acceleration, 1e-2},
    {"in/s^2", acceleration, inch},
    {"ft/s^2", acceleration, 12.0 * inch},
    {"m/s", velocity, 1.0},
    {"um/s", velocity, 1e-6},
    {"mm/s", velocity, 1e-3},
    {"cm/s", velocity, 1e-2},
    {"in/s", velocity, inch},
    {"ft/s", velocity, 12.0 * inch},
    {"m", displacement, 1.0},
    {"cm", displacement, 1e-2},
    {"mm", displacement, 1e-3},
    {"um", displacement, 1e-6},
    {"ft", displacement, 12.0 * inch},
    {"in", displacement, inch},
    {"mil", displacement, 1e-3 * inch},
});

struct Spelling {
  std::string_view text;
  std::string_view usual;
};

// What other programs call units of the table.
constexpr auto spellings = std::to_array<Spelling>({
    {"newton", "N"},     {"newtons", "N"},   {"Newton", "N"},
    {"Newtons", "N"},    {"lbs", "lbf"},     {"LB", "lbf"},
    {"LBF", "lbf"},      {"pound", "lbf"},   {"pounds", "lbf"},
    {"Pound", "lbf"},    {"Pounds", "lbf"},  {"pound-force", "lbf"},
    {"kips", "kip"},     {"kp", "kgf"},      {"dyne", "dyn"},
    {"G", "g"},          {"g's", "g"},       {"G's", "g"},
    {"gal", "Gal"},      {"ms^-2", "m/s^2"}, {"ms-2", "m/s^2"},
    {"m.s^-2", "m/s^2"}, {"m.s-2", "m/s^2"}, {"m*s^-2", "m/s^2"},
    {"M/S^2", "m/s^2"},  {"ips", "in/s"},    {"meter", "m"},
    {"micron", "um"},    {"microns", "um"},  {"mils", "mil"},
});

void replace_all(std::string& text,
                 std::string_view from,
                 std::string_view to) {
  std::string result;
  std::string_view rest = text;
  for (std::size_t at = rest.find(from); at != std::string_view::npos;
       at = rest.find(from)) {
    result += rest.substr(0, at);
    result += to;
    rest.remove_prefix(at + from.size());
  }
  result += rest;
  text = result;
}

bool in_brackets(std::string_view text) {
  return text.size() > 2 && ((text.front() == '(' && text.back() == ')') ||
                             (text.front() == '[' && text.back() == ']'));
}

// One spelling for "m / s²", "m/s**2", "m/s2", "(m/s^2)", "m/s/s", "m/sec^2".
std::string normalise(std::string_view text) {
  std::string plain(text);
  std::erase(plain, ' ');
  replace_all(plain, "\u00b2", "^2");
  replace_all(plain, "\xb2", "^2");  // Latin-1, as in older files
  replace_all(plain, "\u00b5", "u");
  replace_all(plain, "\u03bc", "u");
  replace_all(plain, "**", "^");
  if (in_brackets(plain)) plain = plain.substr(1, plain.size() - 2);
  replace_all(plain, "inches", "in");
  replace_all(plain, "inch", "in");
  replace_all(plain, "/sec", "/s");
  for (const std::string_view ending : {"/s/s", "/s2"}) {
    if (!plain.ends_with(ending)) continue;
    plain.resize(plain.size() - ending.size());
    plain += "/s^2";
  }
  for (const Spelling& spelling : spellings) {
    if (spelling.text == plain) return std::string(spelling.usual);
  }
  return plain;
}

}  // namespace

std::optional<Unit> find_unit(std::string_view text) {
  const std::string plain = normalise(text);
  for (const Entry& entry : table) {
    if (entry.text == plain) return Unit{entry.quantity, entry.si};
  }
  return std::nullopt;
}

std::optional<SensitivityUnit> find_sensitivity_unit(std::string_view text) {
  std::string plain(text);
  std::erase(plain, ' ');
  const std::size_t slash = plain.find('/');
  if (slash == std::string::npos) return std::nullopt;
  std::string volt = plain.substr(0, slash);
  replace_all(volt, "\u00b5", "u");
  replace_all(volt, "\u03bc", "u");
  double volts = 0.0;
  if (volt == "V") volts = 1.0;
  if (volt == "mV") volts = 1e-3;
  if (volt == "uV") volts = 1e-6;
  const std::optional<Unit> unit = find_unit(plain.substr(slash + 1));
  if (volts == 0.0 || !unit) return std::nullopt;
  return SensitivityUnit{volts, *unit};
}

std::string name(Quantity quantity) {
  switch (quantity) {
    case Quantity::Force:
      return "force";
    case Quantity::Acceleration:
      return "acceleration";
    case Quantity::Velocity:
      return "velocity";
    case Quantity::Displacement:
      return "displacement";
  }
  return {};
}

std::optional<Quantity> find_quantity(std::string_view text) {
  for (const Quantity quantity :
       {force, acceleration, velocity, displacement}) {
    if (name(quantity) == text) return quantity;
  }
  return std::nullopt;
}

std::string known_units(Quantity quantity) {
  std::string list;
  for (const Entry& entry : table) {
    if (entry.quantity != quantity) continue;
    if (!list.empty()) list += ", ";
    list += entry.text;
  }
  return list;
}

}  // namespace tapfit::acquisition
