// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace CLI {
class App;
}

namespace shapegauge {

/// Exit statuses of the program (docs/reference/definitions.md#exit-status).
/// @{
inline constexpr int exit_success = 0;         ///< the command completed
inline constexpr int exit_with_failures = 1;   ///< the command completed with failures, which messages name
inline constexpr int exit_unusable_input = 2;  ///< input or arguments are unusable; the command did nothing
inline constexpr int exit_not_passed = 3;      ///< `check` found a part that does not pass
/// @}
// An interrupted program exits with 128 and the number of the signal: 130 (SIGINT), 143 (SIGTERM), 129 (SIGHUP).

/// Installs signal handlers. interrupted() reports the first SIGINT (Ctrl-C), SIGTERM or SIGHUP; a second one ends the
/// program. An ignored SIGHUP (nohup) stays ignored.
void catch_interruption();

/// Returns true if the program was interrupted since catch_interruption().
bool interrupted();

/// Returns the exit status of an interrupted program: 128 plus the number of the signal.
int interruption_status();

/// Returns the direct subcommands of the program or of one of its commands, for shell completions.
std::vector<const CLI::App*> commands_of(const CLI::App& app);

/// Adds the options and all commands of the program to an app. A command runs while the arguments are parsed and stores
/// its exit status in `status`, which must outlive the app.
void add_commands(CLI::App& app, int& status);

/// Commands of the program, in the order of its help. Each function adds its subcommand to the app. The command runs
/// while the arguments are parsed and stores its exit status in `status`, which must outlive the app.
/// @{
void add_run_command(CLI::App& app, int& status);      ///< adds `run`: runs an experiment from its configuration
void add_sdf_command(CLI::App& app, int& status);      ///< adds `sdf`: computes the shape diameter function of a shape
void add_check_command(CLI::App& app, int& status);    ///< adds `check`: checks parts for thin walls and narrow gaps
void add_normals_command(CLI::App& app, int& status);  ///< adds `normals`: estimates the normals of a shape
void add_info_command(CLI::App& app, int& status);     ///< adds `info`: prints diagnostics of a shape
void add_perturb_command(CLI::App& app, int& status);  ///< adds `perturb`: perturbs a shape at random
void add_convert_command(CLI::App& app, int& status);  ///< adds `convert`: converts a shape to another format
void add_segment_command(CLI::App& app, int& status);  ///< adds `segment`: segments a shape into parts
void add_view_command(CLI::App& app, int& status);  ///< adds `view`: writes a page with interactive 3D views of shapes
void add_describe_command(CLI::App& app, int& status);   ///< adds `describe`: computes features of shapes
void add_search_command(CLI::App& app, int& status);     ///< adds `search`: searches a collection for similar shapes
void add_distances_command(CLI::App& app, int& status);  ///< adds `distances`: computes distances between features
void add_rerank_command(CLI::App& app, int& status);     ///< adds `rerank`: re-ranks distances
void add_evaluate_command(CLI::App& app, int& status);   ///< adds `evaluate`: evaluates a distance matrix
void add_compare_command(CLI::App& app, int& status);    ///< adds `compare`: compares methods on the same queries
void add_audit_command(CLI::App& app, int& status);      ///< adds `audit`: evaluates as several evaluation programs do
void add_leaderboard_command(CLI::App& app, int& status);              ///< adds `leaderboard`: ranks submitted methods
void add_segmentation_evaluation_command(CLI::App& app, int& status);  ///< adds the command `evaluate-segmentation`
void add_measures_command(CLI::App& app, int& status);  ///< adds `measures`: prints the definitions of the measures
void add_dataset_command(CLI::App& app, int& status);   ///< adds `dataset`: describes, checks and generates data sets
void add_cache_command(CLI::App& app, int& status);     ///< adds `cache`: manages the cache of results
void add_completion_command(CLI::App& app,
                            int& status);  ///< adds `completion`: prints shell completions of the commands added so far
/// @}

}  // namespace shapegauge
