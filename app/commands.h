#pragma once

#include <vector>

namespace CLI {
class App;
}

namespace shapegauge {

/// Exit statuses of the program (docs/reference/definitions.md#exit-status).
/// @{
inline constexpr int exit_success = 0;
inline constexpr int exit_with_failures = 1;   ///< finished, but something failed that the messages name
inline constexpr int exit_unusable_input = 2;  ///< unusable input or arguments; nothing was done
/// @}
// An interrupted program exits with 128 and the number of the signal: 130 (SIGINT), 143 (SIGTERM), 129 (SIGHUP).

/// Makes interrupted() answer the first SIGINT (Ctrl-C), SIGTERM or SIGHUP instead of ending the program; a second one
/// ends it. A SIGHUP that is ignored (nohup) stays so.
void catch_interruption();

/// Whether the program has been interrupted since catch_interruption().
bool interrupted();

/// The exit status of a program that has been interrupted.
int interruption_status();

/// The commands that the app, or a command, has.
std::vector<const CLI::App*> commands_of(const CLI::App& app);

/// The commands of the program, in the order of its help. Each adds its subcommand to the app. The command runs while
/// the arguments are parsed and stores its exit status in `status`, which must outlive the app.
/// @{
void add_run_command(CLI::App& app, int& status);                      ///< an experiment from its configuration
void add_sdf_command(CLI::App& app, int& status);                      ///< the shape diameter function of a shape
void add_normals_command(CLI::App& app, int& status);                  ///< the normals of a shape
void add_info_command(CLI::App& app, int& status);                     ///< diagnostics of a shape
void add_perturb_command(CLI::App& app, int& status);                  ///< a shape, changed at random
void add_convert_command(CLI::App& app, int& status);                  ///< a shape in another format
void add_segment_command(CLI::App& app, int& status);                  ///< a shape, cut into parts
void add_view_command(CLI::App& app, int& status);                     ///< a page of shapes that one can turn
void add_describe_command(CLI::App& app, int& status);                 ///< the features of shapes
void add_search_command(CLI::App& app, int& status);                   ///< shapes of a collection like one
void add_distances_command(CLI::App& app, int& status);                ///< distances between features
void add_rerank_command(CLI::App& app, int& status);                   ///< distances, re-ranked
void add_evaluate_command(CLI::App& app, int& status);                 ///< the evaluation of a distance matrix
void add_compare_command(CLI::App& app, int& status);                  ///< methods on the same queries
void add_leaderboard_command(CLI::App& app, int& status);              ///< submissions, checked and ranked
void add_segmentation_evaluation_command(CLI::App& app, int& status);  ///< segmentations against people's
void add_measures_command(CLI::App& app, int& status);                 ///< the definitions of the measures
void add_dataset_command(CLI::App& app, int& status);                  ///< data sets: look at, check, generate
void add_cache_command(CLI::App& app, int& status);                    ///< the cache of runs
void add_completion_command(CLI::App& app, int& status);  ///< completion for shells, of all commands added to the app
/// @}

}  // namespace shapegauge
