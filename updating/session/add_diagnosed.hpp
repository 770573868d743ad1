// Adds to a session's model what its diagnosis supports.
#pragma once

#include "updating/session/session.hpp"

namespace tapfit::updating {

/// Fits what is uncertain, then adds the rungs of a diagnosis in order.
void add_ladder(Session& session,
                const Diagnosis& diagnosis,
                const Progress& progress);

/// Diagnoses the session's test. Fits what is uncertain, then adds the ladder's
/// rungs in order, of a group of look-alikes the most probable one.
/// @return the diagnosis, which the session itself drops as its model changes
Diagnosis add_diagnosed(Session& session, const Progress& progress);

}  // namespace tapfit::updating
