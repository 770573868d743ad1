#include "signal/estimate/estimate_frfs.hpp"
#include "tui/commands/commands.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/hits_text.hpp"
#include "tui/report/json_text.hpp"
#include "updating/session/session.hpp"

#include <nlohmann/json.hpp>

namespace tapfit::tui {

std::string hits_command(const CommandOptions& options,
                         const Progress& progress) {
  updating::Session session = open_bundle(options.input);
  acquisition::HitSet hits = session.hits(progress);
  for (std::string& said : signal::block_statements(
           session.bundle(), session.recordings(progress), hits, {})) {
    hits.statements.push_back(std::move(said));
  }
  return options.json ? json_text(hits_json(session.bundle(), hits))
                      : hits_text(session.bundle(), hits);
}

}  // namespace tapfit::tui
