// Text without blanks around it, and in capitals.
#pragma once

#include <string>

namespace tapfit {

[[nodiscard]] std::string trimmed(const std::string& text);
[[nodiscard]] std::string upper(std::string text);

}  // namespace tapfit
