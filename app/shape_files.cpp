// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/shape_files.h"

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdio>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>
#include <optional>
#include <system_error>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/standard_streams.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/base/utf8.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/shape/polygons.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/engine/run_control.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

/// Returns the extensions of shape formats without their dots.
std::vector<std::string> shape_input_formats() {
  std::vector<std::string> formats;
  for (const std::string_view extension : shape_extensions()) formats.emplace_back(extension.substr(1));
  return formats;
}

/// Replaces folders by their shapes.
std::vector<fs::path> with_shapes_of_folders(const std::vector<std::string>& words) {
  std::vector<fs::path> inputs;
  for (const std::string& word : words) {
    if (!is_folder(word)) {
      inputs.emplace_back(word);
      continue;
    }
    const std::vector<fs::path> shapes = model_files(word);
    if (shapes.empty()) {
      throw InputError(
          fmt::format("{}: the folder has no shapes ({}); folders in it are not searched, name them as {}/*/", word,
                      fmt::join(unambiguous_shape_extensions(), ", "), word));
    }
    inputs.insert(inputs.end(), shapes.begin(), shapes.end());
  }
  return inputs;
}

/// Returns true if the outputs go into a folder.
bool fills_folder(const ShapeFiles& files) {
  if (files.output.empty() || is_standard_stream(files.output)) return false;
  return files.inputs.size() > 1 || !files.output.has_filename() || fs::is_directory(files.output);
}

void check_inputs(const ShapeFiles& files) {
  if (files.inputs.size() < 2 || files.output.empty()) return;
  const bool named_like_a_file = files.output.has_filename() && files.output.has_extension();
  if (is_standard_stream(files.output) || (named_like_a_file && !fs::is_directory(files.output))) {
    throw InputError(fmt::format("{} shapes need a result folder, such as -o {}/; {} is a single file",
                                 files.inputs.size(), files.output.stem().string(), files.output.string()));
  }
}

/// Returns all output files of the jobs and of the command.
std::vector<OutputFile> outputs_of(const ShapeFiles& files, const std::vector<ShapeJob>& jobs) {
  std::vector<OutputFile> outputs;
  for (const ShapeJob& job : jobs) {
    const std::string what = jobs.size() > 1 ? "the result of " + job.input : "--output";
    outputs.push_back({.path = job.output, .what = what, .takes_stream = true, .may_be_input = true});
  }
  outputs.insert(outputs.end(), files.others.begin(), files.others.end());
  return outputs;
}

std::vector<ShapeJob> jobs_of(const ShapeFiles& files) {
  check_inputs(files);
  const bool folder = fills_folder(files);
  std::vector<ShapeJob> jobs;
  for (const fs::path& input : files.inputs) {
    const bool stream = is_standard_stream(input);
    ShapeJob job{.index = jobs.size(), .input = stream ? "standard input" : input.string(), .output = files.output};
    if (folder) job.output /= (stream ? "stdin" : input.stem().string()) + "." + files.output_format;
    jobs.push_back(std::move(job));
  }
  check_output_files(files.inputs, outputs_of(files, jobs), files.replace);
  if (!folder) return jobs;
  std::error_code failure;
  fs::create_directories(files.output, failure);
  if (!fs::is_directory(files.output)) {
    throw InputError(fmt::format("cannot create the folder {}: {}", files.output.string(), failure.message()));
  }
  return jobs;
}

Shape read_input(const fs::path& input, const std::string& format) {
  const ShapeSource source = is_standard_stream(input)
                                 ? ShapeSource{.bytes = to_utf8(read_standard_input()), .name = "standard input"}
                                 : read_shape_source(input);
  if (!format.empty()) return read_shape(source, "." + format);
  if (is_recognised_shape(source)) return read_shape(source);
  if (const auto advice = unsupported_format_advice(input)) {
    throw InputError(fmt::format("{}: {}", source.name, *advice));
  }
  throw InputError(
      fmt::format("{}: unknown format: neither the name nor the content identifies it; use --input-format ({})",
                  source.name, fmt::join(shape_input_formats(), ", ")));
}

/// Runs one job. Output for standard output is written to a file first, because writers need a name.
void do_job(const ShapeFiles& files, ShapeJob job,
            const std::function<void(const Shape&, const ShapeJob&, Remarks&)>& work, Remarks& remarks) {
  const Stopwatch stopwatch;
  const Shape shape = read_input(files.inputs[job.index], files.input_format);
  job.read_seconds = stopwatch.seconds();
  if (!is_standard_stream(job.output)) return with_source(job.input, [&] { work(shape, job, remarks); });
  const ScratchFolder scratch;
  job.output = scratch.path() / ("output." + files.output_format);
  with_source(job.input, [&] { work(shape, job, remarks); });
  write_standard_output(read_file_bytes(job.output));
}

void print(const Remarks& remarks, const std::string& prefix) {
  for (const std::string& text : remarks.notes) note(prefix + text);
  for (const std::string& text : remarks.warnings) warn(prefix + text);
}

}  // namespace

void add_shape_inputs(CLI::App& command, ShapeFiles& files) {
  const std::vector<std::string> formats = shape_input_formats();
  begin_option_group(command, input_options);
  command
      .add_option_function<std::vector<std::string>>(
          "input", [&files](const std::vector<std::string>& words) { files.inputs = with_shapes_of_folders(words); },
          fmt::format("Meshes or point clouds ({}), or folders of them; - for standard input",
                      fmt::join(formats, ", ")))
      ->required();
  command.add_option("--input-format", files.input_format, "Format of the inputs (default: by extension or contents)")
      ->check(one_of(formats));
  add_threads_option(command, files.threads);
}

CLI::Option* add_shape_outputs(CLI::App& command, ShapeFiles& files, const std::string& description) {
  begin_option_group(command, output_options);
  CLI::Option* const output =
      command
          .add_option("-o,--output", files.output,
                      "Output file: " + description + "; folder for several inputs; - for standard output")
          ->required();
  command
      .add_option("--output-format", files.output_format,
                  "Format of results in a folder or on standard output, as a file extension without the dot")
      ->capture_default_str();
  command.add_flag("--replace", files.replace, "Overwrite existing files");
  return output;
}

void remark_on_polygons(const Shape& shape, SampleSite site, Remarks& remarks) {
  const std::optional<std::string> polygons = polygon_note(shape);
  if (site != SampleSite::faces || !polygons) return;
  remarks.notes.push_back(*polygons +
                          ": values are by triangle, and the column polygon of .csv files has the index of the face");
}

fs::path output_name(const ShapeFiles& files) {
  const bool named = !is_standard_stream(files.output) && !fills_folder(files);
  return named ? files.output : fs::path("output." + files.output_format);
}

int for_each_shape(const ShapeFiles& files,
                   const std::function<void(const Shape& shape, const ShapeJob& job, Remarks& remarks)>& work) {
  const std::vector<ShapeJob> jobs = jobs_of(files);
  std::vector<Remarks> remarks(jobs.size());
  if (jobs.size() == 1) {
    {
      const BusyLine busy(jobs[0].input);
      with_threads(files.threads, [&] { do_job(files, jobs[0], work, remarks[0]); });
    }
    print(remarks[0], "");
    return exit_success;
  }
  std::vector<std::size_t> all(jobs.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  catch_interruption();
  ProgressLine progress;
  const RunControl control{.threads = files.threads, .interrupted = interrupted, .progress = progress.receiver()};
  std::vector<ModelFailure> failures;
  std::atomic<std::size_t> completed = 0;
  try {
    with_threads(files.threads, [&] {
      failures = for_each_model(all, "shapes", false, control, [&](std::size_t i) {
        do_job(files, jobs[i], work, remarks[i]);
        ++completed;
      });
    });
  } catch (const Interrupted&) {
    if (files.output.empty() || completed == 0) throw;
    throw Interrupted(
        fmt::format("interrupted; the results of {} of {} shapes were written", completed.load(), jobs.size()));
  }
  progress.clear();
  for (const ShapeJob& job : jobs) print(remarks[job.index], job.input + ": ");
  for (const ModelFailure& failure : failures) print_error(failure.message);
  if (failures.empty()) return exit_success;
  print_error(fmt::format("{} of {} shapes could not be used", failures.size(), jobs.size()));
  return exit_with_failures;
}

}  // namespace shapegauge
