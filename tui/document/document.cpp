#include "tui/document/document.hpp"

namespace tapfit::tui {

ColumnName column_name(const std::string& heading) {
  if (heading.starts_with('<')) return {heading.substr(1), true};
  return {heading, false};
}

}  // namespace tapfit::tui
