#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/output_files.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// The files of commands that do the same to one shape or to many: `sdf`, `normals`, `info`, `perturb`, `convert`.

namespace shapegauge {

/// The files that such a command is given.
struct ShapeFiles {
  std::vector<std::filesystem::path> inputs = {};  ///< "-": standard input
  std::string input_format = {};                   ///< an extension without the point; empty: by name and first bytes
  std::filesystem::path output = {};  ///< a file, "-" (standard output), or a folder; empty: the command has none
  std::string output_format = {};     ///< an extension without the point, for folders and "-"
  bool replace = false;               ///< outputs may exist, and take the place of inputs
  std::vector<OutputFile> others{};   ///< further outputs of the command, checked with those of the shapes
  int threads = 0;
};

/// Adds the inputs, --input-format and --threads.
void add_shape_inputs(CLI::App& command, ShapeFiles& files);

/// Adds -o, --output-format and --replace. `description`: what the formats are; the usual format is the one already in
/// `files.output_format`. Returns -o, which is required.
CLI::Option* add_shape_outputs(CLI::App& command, ShapeFiles& files, const std::string& description);

/// A name with the format of the outputs, to find their writer before anything is read.
std::filesystem::path output_name(const ShapeFiles& files);

/// What is to be said of one shape, in sentences without the file's name.
struct Remarks {
  std::vector<std::string> notes;
  std::vector<std::string> warnings;
};

/// Adds a note where values are by triangle, but the faces of the mesh's file are polygons.
void remark_on_polygons(const Shape& shape, SampleSite site, Remarks& remarks);

/// One of the shapes, and where its result goes.
struct ShapeJob {
  std::size_t index = 0;         ///< among the inputs
  std::string input;             ///< what messages call it
  std::filesystem::path output;  ///< where to write; its extension is the format
  double read_seconds = 0;
};

/// Reads every input and does the work on it: one after the other where there is one, else in parallel over the shapes,
/// with a line of progress. Work may run in several threads at once. Remarks are printed at the end, in the inputs'
/// order. Returns the exit status.
///
/// Of a single input an error is thrown. Of several, one that fails is named and the others are done (exit status 1).
/// Several outputs go into a folder, made where absent, each under the name of its input. Throws InputError before
/// anything is read where check_output_files() does, and Interrupted.
int for_each_shape(const ShapeFiles& files,
                   const std::function<void(const Shape& shape, const ShapeJob& job, Remarks& remarks)>& work);

}  // namespace shapegauge
