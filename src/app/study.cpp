#include "app/commands.hpp"

namespace talus::app {

void add_study(CLI::App& /*app*/) {}

}  // namespace talus::app
