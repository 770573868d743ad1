#include "updating/session/add_diagnosed.hpp"

namespace tapfit::updating {

void add_ladder(Session& session,
                const Diagnosis& diagnosis,
                const Progress& progress) {
  session.fit_uncertain(progress);
  for (const auto& rung : diagnosis.ladder) {
    const std::string effect = rung.added.substr(0, rung.added.find('|'));
    session.add({effect, rung.where, rung.place_sd, rung.sizes}, progress);
  }
}

Diagnosis add_diagnosed(Session& session, const Progress& progress) {
  Diagnosis diagnosis = session.diagnosis(progress);
  add_ladder(session, diagnosis, progress);
  return diagnosis;
}

}  // namespace tapfit::updating
