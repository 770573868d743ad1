#include "updating/session/add_diagnosed.hpp"

namespace tapfit::updating {

Diagnosis add_diagnosed(Session& session, const Progress& progress) {
  Diagnosis diagnosis = session.diagnosis(progress);
  session.fit_uncertain(progress);
  for (const auto& rung : diagnosis.ladder) {
    const std::string effect = rung.added.substr(0, rung.added.find('|'));
    session.add({effect, rung.where}, progress);
  }
  return diagnosis;
}

}  // namespace tapfit::updating
