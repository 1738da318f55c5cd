#include <cstdint>
#include <cstdio>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <talus/files/path_text.h>
#include <talus/mistyped/command_line.h>
#include <talus/terrain/world.h>
#include <talus/tools/command.h>
#include <talus/vectors/instruction_set.h>
#include <CLI/CLI.hpp>

namespace talus::tools {
namespace {

int report(const Program& program, const Failure& failure, const std::string& command) {
  std::fprintf(stderr, "%s %s: %s\n", program.name.c_str(), command.c_str(), failure.message.c_str());
  return failure.exit_code;
}

int parse_failure(const Program& program, const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    return app.exit(error);  // --help and --version arrive here
  }
  std::fprintf(stderr, "%s: %s (see --help)\n", program.name.c_str(), describe(app, error).c_str());
  return kExitWrongUse;
}

std::string names_of(const std::vector<Command>& commands) {
  std::string names;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (i > 0) names += i + 1 < commands.size() ? ", " : " or ";
    names += commands[i].options->get_name();
  }
  return names;
}

}  // namespace

void add_world(CLI::App& command, std::string& world) {
  command.add_option("--world", world, "World spec (world.toml); default: the built-in world")
      ->type_name("FILE");
}

void add_threads(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Threads; 0: one a core")
      ->check(CLI::Range(0, 1024))
      ->type_name("N")
      ->capture_default_str();
}

void add_lod(CLI::App& command, std::int64_t& lod) {
  command.add_option("--lod", lod, "Level of detail, 0 to 6: one column spans 2^L base voxels")
      ->type_name("L")
      ->capture_default_str();
}

void add_output(CLI::App& command, std::string& output, const char* meaning, const char* type) {
  auto* const option = command.add_option("-o,--output", output, meaning)->type_name(type)->required();
  if (std::string_view{type} != "F.png") return;
  option->check([](const std::string& path) {
    const std::string extension = files::to_text(files::to_path(path).extension());
    const bool fits = extension.empty() || extension == ".png";
    return fits ? std::string{} : path + ": pictures are PNG; give a name that ends in .png";
  });
}

int run_program(const Program& program, int argc, const char* const* argv) {
  if (const auto set = forced_instruction_set(); !set) {
    std::fprintf(stderr, "%s: %s\n", program.name.c_str(), std::string{set.error()}.c_str());
    return kExitWrongUse;
  }
  CLI::App app{program.description + "\nExit status: 0 success, 1 failure, 2 wrong arguments."};
  app.name(program.name);
  app.set_version_flag("--version", program.name + " " + program.version + " (generator version " +
                                        std::to_string(to_integer(terrain::kNewestGeneratorVersion)) + ", " +
                                        std::string{to_string(instruction_set())} + " kernels)");
  app.get_formatter()->column_width(34);

  const std::vector<Command> commands = program.add_commands(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return parse_failure(program, app, error);
  }
  for (const auto& [command, run] : commands) {
    if (!command->parsed()) continue;
    try {
      const Expected<void> done = run();
      return done ? kExitDone : report(program, done.error(), command->get_name());
    } catch (const std::system_error& error) {
      return report(
          program,
          {kExitFailed, std::string{"cannot go on: "} + error.what() + "; fewer --threads need less"},
          command->get_name());
    } catch (const std::bad_alloc&) {
      return report(program, {kExitFailed, "not enough memory; ask for a smaller region or fewer --threads"},
                    command->get_name());
    }
  }
  std::fprintf(stderr, "%s: a command is needed: %s (see --help)\n", program.name.c_str(),
               names_of(commands).c_str());
  return kExitWrongUse;
}

}  // namespace talus::tools
