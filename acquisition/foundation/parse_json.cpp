#include "acquisition/foundation/parse_json.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace tapfit {

using nlohmann::json;

json parse_json(const std::string& text, const std::string& source) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    const std::size_t at =
        std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
    const auto here = text.begin() + static_cast<std::ptrdiff_t>(at);
    const auto line = 1 + std::count(text.begin(), here, '\n');
    const std::size_t start =
        at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const std::size_t column = start == std::string::npos ? at + 1 : at - start;
    std::string what = error.what();
    const std::size_t colon = what.find("syntax error");
    if (colon != std::string::npos) what = what.substr(colon);
    const bool encoding = what.find("UTF-8") != std::string::npos;
    throw InputError(
        what,
        fmt::format("{}:{}:{}", source, line, column),
        encoding ? "save the file as UTF-8 text"
                 : "look for a missing comma, quote or bracket just before");
  } catch (const json::exception& error) {
    throw InputError(error.what(), source, "correct the JSON");
  }
}

}  // namespace tapfit
