#include "tui/report/json_text.hpp"

#include <nlohmann/json.hpp>

namespace tapfit::tui {

std::string json_text(const nlohmann::ordered_json& object) {
  using Handler = nlohmann::ordered_json::error_handler_t;
  return object.dump(2, ' ', false, Handler::replace) + "\n";
}

}  // namespace tapfit::tui
