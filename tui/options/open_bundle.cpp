#include "tui/options/open_bundle.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace tapfit::tui {

std::vector<std::string> input_warnings(updating::Session& session) {
  std::vector<std::string> warnings = session.bundle().warnings;
  if (session.bundle().deck) {
    const std::vector<std::string>& deck = session.deck().warnings;
    warnings.insert(warnings.end(), deck.begin(), deck.end());
  }
  return warnings;
}

updating::Diagnosis with_input_warnings(updating::Diagnosis diagnosis,
                                        updating::Session& session) {
  const std::vector<std::string> more = input_warnings(session);
  diagnosis.warnings.insert(diagnosis.warnings.end(), more.begin(), more.end());
  return diagnosis;
}

updating::Session open_bundle(const std::filesystem::path& bundle) {
  updating::Session session(bundle);
  for (const std::string& warning : input_warnings(session)) {
    fmt::print(stderr, "note: {}\n", warning);
  }
  return session;
}

}  // namespace tapfit::tui
