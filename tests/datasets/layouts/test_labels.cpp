// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <gmock/gmock.h>

#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/datasets/layouts/labels.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test::write_text;
using testing::ElementsAre;
using testing::HasSubstr;

class ModelLabelsOfFiles : public test::FolderTest {
 protected:
  std::filesystem::path file(const std::string& name, const std::string& text) {
    write_text(at(name), text);
    return at(name);
  }
  [[nodiscard]] std::filesystem::path folder() const { return folder_.path(); }
};

const char* const hierarchy = "PSB 1\n4 3\nanimal 0 0\nbiped animal 0\nhuman biped 2\n1 2\nlamp 0 1\n3\n";

std::vector<std::string> classes_of(const ModelLabels& labels) {
  std::vector<std::string> names;
  for (const ModelClass& known : labels.classification.classes) names.push_back(known.name);
  return names;
}

TEST_F(ModelLabelsOfFiles, AreReadFromAClassification) {
  const ModelLabels labels = read_labels(file("a.cla", hierarchy));
  EXPECT_THAT(labels.classification.classes[2].models, ElementsAre("1", "2"));
  EXPECT_THAT(labels.queries, ElementsAre("1", "2", "3"));
  EXPECT_FALSE(labels.separate_sets);
}

TEST_F(ModelLabelsOfFiles, AreAncestorClassesAtTheRequestedLevel) {
  const auto path = file("a.cla", hierarchy);
  const auto names = [&](std::size_t level) {
    std::vector<std::string> found;
    for (const ModelClass& known : read_labels(path, level).classification.classes) found.push_back(known.name);
    return found;
  };
  EXPECT_THAT(names(1), ElementsAre("animal", "lamp"));
  EXPECT_THAT(names(2), ElementsAre("biped", "lamp"));
  EXPECT_THAT(names(3), ElementsAre("human", "lamp"));
  EXPECT_THAT(names(9), ElementsAre("human", "lamp"));
}

TEST_F(ModelLabelsOfFiles, ExcludeTheClassMinusOneFromQueries) {
  const ModelLabels labels = read_labels(file("a.cla", "PSB 1\n2 3\nant 0 2\n1\n3\n-1 0 1\n2\n"));
  EXPECT_THAT(labels.queries, ElementsAre("1", "3"));
  EXPECT_THAT(labels.targets, ElementsAre("1", "3", "2"));
  EXPECT_TRUE(labels.separate_sets);
}

TEST_F(ModelLabelsOfFiles, DivideModelsByTheSplitColumnOfATable) {
  const ModelLabels labels =
      read_labels(file("a.csv", "class,id,split\nant,1,query\nant,2,target\nbee,3,both\nbee,4,\nbee,5,train\n"));
  EXPECT_THAT(labels.queries, ElementsAre("1", "3", "4"));
  EXPECT_THAT(labels.targets, ElementsAre("2", "3", "4", "5"));
  EXPECT_TRUE(labels.separate_sets);
  EXPECT_FALSE(read_labels(file("b.csv", "id,class\n1,ant\n2,ant\n")).separate_sets);
}

TEST_F(ModelLabelsOfFiles, AreReadFromTheNamesOfFolders) {
  file("models/ant/T1.off", "OFF\n");
  file("models/bee/T2.off", "OFF\n");
  const ModelLabels labels = read_labels(folder() / "models");
  EXPECT_EQ(labels.classification.classes[1].name, "bee");
  EXPECT_THAT(labels.queries, ElementsAre("ant/T1", "bee/T2"));
}

TEST_F(ModelLabelsOfFiles, OfQueriesAndTargetsShareClassesByName) {
  const auto queries = file("q.cla", "PSB 1\n2 2\nant 0 1\n1\nbee 0 1\n2\n");
  const auto targets = file("t.cla", "PSB 1\n2 3\nbee 0 2\n2 3\ncow 0 1\n4\n");
  const TaskLabels two = read_query_and_target_labels(queries, targets);
  EXPECT_THAT(classes_of(two.queries), ElementsAre("ant", "bee", "cow"));
  EXPECT_THAT(classes_of(two.of_targets()), ElementsAre("ant", "bee", "cow"));
  EXPECT_THAT(two.queries.classification.classes[1].models, ElementsAre("2"));
  EXPECT_THAT(two.of_targets().classification.classes[1].models, ElementsAre("2", "3"));
  const ModelLabels labels = read_shared_labels(queries, targets);
  ASSERT_EQ(labels.classification.classes.size(), 3U);
  EXPECT_THAT(labels.classification.classes[1].models, ElementsAre("2", "3"));
  EXPECT_THAT(labels.queries, ElementsAre("1", "2"));
  EXPECT_THAT(labels.targets, ElementsAre("2", "3", "4"));
  const auto other = file("u.cla", "PSB 1\n1 1\nant 0 1\n2\n");
  EXPECT_NO_THROW(read_query_and_target_labels(queries, other)) << "two models of the id 2";
  EXPECT_THAT(test::input_error_of([&] { read_shared_labels(queries, other); }),
              AllOf(HasSubstr("u.cla: model \"2\""), HasSubstr("\"ant\""), HasSubstr("\"bee\"")));
}

TEST_F(ModelLabelsOfFiles, DistinguishFilesOfOneNameByTheirExtensions) {
  const auto path = file("labels.csv", "id,class,subclass\nm0.off,a,x\nm0.obj,b,y\nm1.off,a,\n");
  const ModelLabels labels = read_labels(path);
  EXPECT_THAT(labels.models, ElementsAre("m0.off", "m0.obj", "m1.off"));
  EXPECT_EQ(labels.subclasses.at("m0.obj"), "y");
  EXPECT_EQ(labels.keys.of("m1"), labels.keys.of("m1.off"));
  const ModelLabels both = read_shared_labels(path, file("t.csv", "id,class,subclass\nm1.obj,a,z\nm2,b,\n"));
  EXPECT_THAT(both.models, ElementsAre("m0.off", "m0.obj", "m1.off", "m2"));
  EXPECT_EQ(both.subclasses.at("m0.off"), "x");
  EXPECT_EQ(both.subclasses.at("m1"), "z");
}

TEST_F(ModelLabelsOfFiles, ErrorMessagesGiveTheLineNumber) {
  test::expect_refused({{"id,kind\n1,a\n", "id and class"},
                        {"id,class\n1,a\nT1.off,b\n", "labels.csv:3: model \"T1.off\" is the same as \"1\""},
                        {"id,class\nm0.off,a\nm0.obj,b\nm0.off,b\n", "labels.csv:4: repeated model"},
                        {"id,class\n1\n", "labels.csv:2: 1 cell"},
                        {"id,class,Label\n1,a,b\n", "labels.csv:1: "},
                        {"id,class\n,a\n", "labels.csv:2: the id"},
                        {"id,class\n1,\n", "labels.csv:2: the class"},
                        {"id,class,split\n1,a,left\n", "labels.csv:2: the split"},
                        {"id,class\n", "no models"}},
                       [&](const std::string& text) { read_labels(file("labels.csv", text)); });
  EXPECT_THAT(test::input_error_of([&] { read_labels(file("labels.csv", "id,class\n1,a\n"), 2); }),
              HasSubstr("no level 2"));
}

TEST_F(ModelLabelsOfFiles, AcceptSynonymsOfColumnNamesAndAnySeparator) {
  for (const char* text :
       {"name,label\nb,bee\na,ant\n", "Label;File\nbee;b\nant;a\n", "b\tbee\na\tant\n", "b,bee\r\na,ant\r\n",
        "x,id,Category\n1,b,bee\n2,a,ant\n", "# by hand\r\n# twice\r\nid,class\r\nb,bee\r\na,ant\r\n,\r\n"}) {
    const ModelLabels labels = read_labels(file("labels.tsv", text));
    EXPECT_THAT(labels.models, ElementsAre("b", "a")) << text;
    EXPECT_THAT(classes_of(labels), ElementsAre("bee", "ant")) << text;
    EXPECT_TRUE(labels.listed);
    EXPECT_FALSE(labels.without_ids);
  }
}

TEST_F(ModelLabelsOfFiles, AreReadFromLinesOfIdsAndClasses) {
  const ModelLabels labels = read_labels(file("words.txt", "id label\n10 big ant\n\n2\t bee\n1  big ant\n"));
  EXPECT_FALSE(labels.without_ids);
  EXPECT_THAT(labels.models, ElementsAre("10", "2", "1"));
  EXPECT_THAT(classes_of(labels), ElementsAre("big ant", "bee"));
  // Recognized as lists of classes: words without digits, repeated first words, classes without repetition.
  for (const char* const text : {"red ant\nold ant\nnew bee\n", "0 ant\n0 bee\n1 bee\n", "0 ant\n1 bee\n"}) {
    EXPECT_TRUE(read_labels(file("list.txt", text)).without_ids) << text;
  }
}

TEST_F(ModelLabelsOfFiles, AreReadFromOneClassPerLine) {
  const ModelLabels labels = read_labels(file("labels.txt", "bee\nbig ant\n\nbee\n"));
  EXPECT_THAT(labels.models, ElementsAre("0", "1", "2"));
  EXPECT_THAT(classes_of(labels), ElementsAre("bee", "big ant"));
  EXPECT_THAT(labels.classification.classes[0].models, ElementsAre("0", "2"));
  EXPECT_TRUE(labels.listed && labels.without_ids);
  EXPECT_THAT(classes_of(read_labels(file("named.txt", "label\r\nbee\r\nant"))), ElementsAre("bee", "ant"));
}

TEST_F(ModelLabelsOfFiles, AreReadFromIntegerArrays) {
  write_npy_vector(folder() / "y.npy", Eigen::Vector4d(7, -1, 7, 12));
  const ModelLabels labels = read_labels(folder() / "y.npy");
  EXPECT_THAT(classes_of(labels), ElementsAre("7", "-1", "12"));
  EXPECT_THAT(labels.classification.classes[0].models, ElementsAre("0", "2"));
  write_npy_vector(folder() / "z.npy", Eigen::Vector2d(1, 0.5));
  EXPECT_THAT(test::input_error_of([&] { read_labels(folder() / "z.npy"); }), HasSubstr("z.npy: entry 1"));
  write_npy(folder() / "m.npy", DistanceMatrix::Ones(2, 2));
  EXPECT_THAT(test::input_error_of([&] { read_labels(folder() / "m.npy"); }), HasSubstr("one-dimensional"));
}

TEST_F(ModelLabelsOfFiles, OfTwoSetsWithoutIdsShareNoModels) {
  const auto queries = file("q.txt", "bee\nant\n");
  const auto targets = file("t.txt", "ant\nant\n");
  const TaskLabels labels = read_query_and_target_labels(queries, targets);
  EXPECT_EQ(labels.queries.queries.size(), 2U);
  EXPECT_EQ(labels.of_targets().targets.size(), 2U);
  EXPECT_EQ(labels.of_targets().classification.classes[1].models.size(), 2U);
  EXPECT_THAT(test::input_error_of([&] { read_shared_labels(queries, targets); }),
              HasSubstr("q.txt: the file has no ids"));
}

TEST_F(ModelLabelsOfFiles, OfQueriesAmongTheTargetsFollowTheOrderOfTargets) {
  const auto queries = file("public.csv", "id,class\n3,a\n1,b\n");
  const auto all = file("all.csv", "id,class\n1,b\n2,a\n3,a\n");
  EXPECT_THAT(read_shared_labels(queries, all).models, ElementsAre("1", "2", "3"));
}

TEST_F(ModelLabelsOfFiles, RejectFormatsWithoutLabels) {
  for (const char* const name : {"l.npz", "l.html", "l.PNG", "l.off", "l.step"}) {
    EXPECT_THAT(test::input_error_of([&] { read_labels(file(name, "a\nb\n")); }), HasSubstr("files have no labels"))
        << name;
  }
  using namespace std::string_literals;
  EXPECT_THAT(test::input_error_of([&] { read_labels(file("l.txt", "a\0b\n"s)); }), HasSubstr("not text in UTF-8"));
}

TEST_F(ModelLabelsOfFiles, WarnOfClassNamesThatDenoteMissingValues) {
  EXPECT_THAT(missing_class_warnings(read_labels(file("labels.csv", "id,class\n1,nan\n2,<NA>\n3,nan\n4,Nan\n"))),
              ElementsAre(HasSubstr("labels.csv: 2 models have the class \"nan\""),
                          HasSubstr("1 model has the class \"<NA>\"")));
  EXPECT_THAT(missing_class_warnings(read_labels(file("list.txt", "None\nNaT\nNULL\nNaN\nNA\n#N/A\n"))),
              testing::SizeIs(6));
  EXPECT_THAT(missing_class_warnings(read_labels(file("list.txt", "nano\nnone\n"))), testing::IsEmpty());
}

std::string npy_of(const std::string& type, const std::string& shape, const std::string& data) {
  const std::string dictionary = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + "}";
  std::string bytes = "\x93NUMPY";
  bytes += {'\x01', '\0', static_cast<char>(dictionary.size()), '\0'};
  return bytes + dictionary + data;
}

std::string utf32(const std::u32string& text, bool big_endian) {
  std::string bytes;
  for (const char32_t character : text) {
    for (unsigned k = 0; k < 4; ++k) {
      bytes += static_cast<char>(static_cast<unsigned char>(character >> 8 * (big_endian ? 3 - k : k)));
    }
  }
  return bytes;
}

TEST_F(ModelLabelsOfFiles, AreReadFromStringArrays) {
  using namespace std::string_literals;
  const std::u32string text = U"cat\0k\u00f6\u732b\U0001F41F"s;
  for (const bool big_endian : {false, true}) {
    const std::string bytes = npy_of(big_endian ? ">U4" : "<U4", "(2,)", utf32(text, big_endian));
    const ModelLabels labels = read_labels(file("y.npy", bytes));
    ASSERT_EQ(labels.classification.classes.size(), 2U);
    EXPECT_EQ(labels.classification.classes[0].name, "cat");
    EXPECT_EQ(labels.classification.classes[1].name, "k\xC3\xB6\xE7\x8C\xAB\xF0\x9F\x90\x9F");
    EXPECT_THAT(labels.models, ElementsAre("0", "1"));
    EXPECT_TRUE(labels.without_ids);
  }
  const ModelLabels bytes = read_labels(file("s.npy", npy_of("|S3", "(3, 1)", "ox\0catox\0"s)));
  EXPECT_THAT(bytes.classification.classes[0].models, ElementsAre("0", "2"));
  EXPECT_EQ(bytes.classification.classes[0].name, "ox");
}

TEST_F(ModelLabelsOfFiles, RejectPickledTruncatedAndTwoDimensionalStringArrays) {
  using namespace std::string_literals;
  test::expect_refused({{npy_of("|O", "(2,)", "pickled"), "dtype=str"},
                        {npy_of("|S3", "(2,)", "ox\0\0\0\0"s), "entry 1"},
                        {npy_of("|S3", "(2,)", "ox\0nan"s), "entry 1"},
                        {npy_of("|S3", "(2,)", "ox"), "truncated"},
                        {npy_of("|S1", "(2, 2)", "oxox"), "one-dimensional"},
                        {npy_of("<U1", "(2,)", utf32(U"a", false) + "\0\0\x11\0"s), "entry 1"},
                        {npy_of("<U1", "(99999999999999,)", "abcd"), "truncated"},
                        {npy_of("<U99999999999999999999", "(1,)", "abcd"), "not supported"}},
                       [&](const std::string& bytes) { read_labels(file("y.npy", bytes)); });
}

}  // namespace

}  // namespace shapegauge
