#include "acquisition/foundation/parse_json.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace tapfit {

using nlohmann::json;

namespace {

/// "source:line:column" of a byte.
std::string place(const std::string& text,
                  std::size_t at,
                  const std::string& source) {
  const auto here = text.begin() + static_cast<std::ptrdiff_t>(at);
  const auto line = 1 + std::count(text.begin(), here, '\n');
  const std::size_t start =
      at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  const std::size_t column = start == std::string::npos ? at + 1 : at - start;
  return fmt::format("{}:{}:{}", source, line, column);
}

/// Without the library's name of the fault.
std::string plain(const json::exception& error) {
  const std::string what = error.what();
  const std::size_t end = what.find("] ");
  return end == std::string::npos ? what : what.substr(end + 2);
}

}  // namespace

json parse_json(const std::string& text, const std::string& source) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    const std::size_t at =
        std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
    std::string what = plain(error);
    const std::size_t fault = what.find("syntax error");
    if (fault != std::string::npos) what = what.substr(fault);
    const bool encoding = what.find("UTF-8") != std::string::npos;
    throw InputError(
        what,
        place(text, at, source),
        encoding ? "save the file as UTF-8 text"
                 : "look for a missing comma, quote or bracket just before");
  } catch (const json::out_of_range& error) {  // names the number in quotes
    const std::string what = plain(error);
    const std::size_t quote = what.find('\'');
    const std::string number =
        quote == std::string::npos
            ? what
            : what.substr(quote + 1, what.rfind('\'') - quote - 1);
    throw InputError(
        fmt::format("the number {} is larger than any that is read", number),
        place(text, std::min(text.find(number), text.size()), source),
        "write a number below 1e308");
  }
}

}  // namespace tapfit
