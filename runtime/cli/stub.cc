#include "runtime/cli/commands.h"
namespace plsc::cli {
Exit Run(const FmtCommand&, Io&) { return Exit::kBadUsage; }
Exit Run(const EvolveCommand&, Io&) { return Exit::kBadUsage; }
}
