// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "shapegauge/core/io/output_files.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// Files of commands that process one or many shapes: `sdf`, `normals`, `info`, `perturb`, `convert`.

namespace shapegauge {

/// Input and output files of a command that processes shapes.
struct ShapeFiles {
  std::vector<std::filesystem::path> inputs = {};  ///< paths of the shapes; "-" for standard input
  std::string input_format = {};                   ///< format, an extension without dot; empty: from name or content
  std::filesystem::path output = {};  ///< file, folder or "-" (standard output); empty for a command without output
  std::string output_format = {};     ///< extension of outputs without the dot, for folders and "-"
  bool replace = false;               ///< true to allow overwriting existing files, including the inputs
  std::vector<OutputFile> others{};   ///< further outputs of the command, checked together with the shapes' outputs
  int threads = 0;                    ///< number of threads; 0 for all cores
};

/// Adds the positional argument for the input files (a folder stands for the shapes in it), --input-format and
/// --threads.
void add_shape_inputs(CLI::App& command, ShapeFiles& files);

/// Adds -o, --output-format and --replace. `description` lists the formats; the default format is the value of
/// `files.output_format`. Returns -o, which is required.
CLI::Option* add_shape_outputs(CLI::App& command, ShapeFiles& files, const std::string& description);

/// Returns a file name with the extension of the command's outputs, to select a writer by it before inputs are read.
std::filesystem::path output_name(const ShapeFiles& files);

/// Remarks on one shape, as sentences without the file's name.
struct Remarks {
  std::vector<std::string> notes;     ///< information; not printed with --quiet
  std::vector<std::string> warnings;  ///< possible problems of the result
};

/// Adds a note if values at `site` are per triangle although the faces in the shape's file are polygons.
void remark_on_polygons(const Shape& shape, SampleSite site, Remarks& remarks);

/// Input shape of a command and the destination of its result.
struct ShapeJob {
  std::size_t index = 0;         ///< index in ShapeFiles::inputs
  std::string input;             ///< name of the input in messages
  std::filesystem::path output;  ///< path of the output; its extension selects the format
  double read_seconds = 0;       ///< time to read the input, in seconds
};

/// Reads each input and processes it by `work`: several inputs in parallel, with a progress line. `work` may run in
/// several threads at once. Remarks are printed at the end, in the order of inputs. Returns the exit status.
///
/// Errors of `work` name the input. With a single input, errors are thrown. With several, failures are reported by name
/// and the others are processed (exit status 1). Several outputs go into a folder, created if missing, each under the
/// name of its input. Throws InputError as check_output_files() does before anything is read, and Interrupted.
int for_each_shape(const ShapeFiles& files,
                   const std::function<void(const Shape& shape, const ShapeJob& job, Remarks& remarks)>& work);

}  // namespace shapegauge
