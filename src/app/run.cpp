#include "app/commands.hpp"

namespace talus::app {

void add_run(CLI::App& /*app*/) {}

}  // namespace talus::app
