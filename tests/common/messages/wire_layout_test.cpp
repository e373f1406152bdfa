// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The layouts against the .lcm files, read by a parser of this test's own.
#include "fallen/messages/wire_layout.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "fallen/baseline_model_t.hpp"
#include "fallen/clusters_t.hpp"
#include "fallen/depth_image_t.hpp"
#include "fallen/environment_map_t.hpp"
#include "fallen/fall_alarm_ack_t.hpp"
#include "fallen/fall_alarm_t.hpp"
#include "fallen/fallen_persons_t.hpp"
#include "fallen/ground_truth_t.hpp"
#include "fallen/model_t.hpp"
#include "fallen/ndt_map_t.hpp"
#include "fallen/pose_t.hpp"
#include "fallen/service_status_t.hpp"

namespace fallen::wire {
namespace {

// "int32_t a" or "float b[n][3]" of each member, in order, by struct.
using Structs = std::map<std::string, std::vector<std::string>>;

Structs ReadLcmFiles() {
  Structs structs;
  for (const auto& entry : std::filesystem::directory_iterator(FALLEN_SOURCE_DIR "/lcmtypes")) {
    if (entry.path().extension() != ".lcm") continue;
    std::ifstream file(entry.path());
    std::stringstream content;
    content << file.rdbuf();
    const std::string text = std::regex_replace(content.str(), std::regex("//[^\n]*"), "");
    std::smatch match;
    EXPECT_TRUE(std::regex_search(text, match, std::regex("struct\\s+(\\w+)\\s*\\{([^}]*)\\}")));
    std::vector<std::string>& members = structs[match[1]];
    const std::string body = match[2];
    const std::regex member("(const\\s+)?(\\w+)\\s+(\\w+)((\\[\\w+\\])*)\\s*(=[^;]*)?;");
    for (auto it = std::sregex_iterator(body.begin(), body.end(), member);
         it != std::sregex_iterator(); ++it)
      if (!(*it)[1].matched)
        members.push_back((*it)[2].str() + " " + (*it)[3].str() + (*it)[4].str());
  }
  return structs;
}

std::string TypeName(const Field& field) {
  const std::map<Kind, std::string> names = {
      {Kind::kByte, "byte"},     {Kind::kBoolean, "boolean"}, {Kind::kInt8, "int8_t"},
      {Kind::kInt16, "int16_t"}, {Kind::kInt32, "int32_t"},   {Kind::kInt64, "int64_t"},
      {Kind::kFloat, "float"},   {Kind::kDouble, "double"},   {Kind::kString, "string"}};
  return field.kind == Kind::kStruct ? std::string(field.layout->name) : names.at(field.kind);
}

std::string Member(const Field& field) {
  std::string member = TypeName(field) + " " + std::string(field.name);
  for (const Dimension& dimension : {field.outer, field.inner}) {
    if (dimension.is_variable()) member += "[" + std::string(dimension.count_field) + "]";
    if (!dimension.is_variable() && dimension.fixed != 1)
      member += "[" + std::to_string(dimension.fixed) + "]";
  }
  return member;
}

void Compare(const Layout& layout, const Structs& structs, std::set<std::string>& seen) {
  const std::string name(layout.name);
  seen.insert(name);
  ASSERT_EQ(structs.count(name), 1u) << name;
  std::vector<std::string> members;
  for (const Field& field : layout.fields) {
    members.push_back(Member(field));
    if (field.layout != nullptr) Compare(*field.layout, structs, seen);
  }
  EXPECT_EQ(members, structs.at(name)) << name;
}

TEST(WireLayout, AgreesWithEveryLcmFile) {
  const Structs structs = ReadLcmFiles();
  std::set<std::string> seen;
  for (const Layout* layout :
       {&LayoutOf<pose_t>(), &LayoutOf<depth_image_t>(), &LayoutOf<ndt_map_t>(),
        &LayoutOf<clusters_t>(), &LayoutOf<fallen_persons_t>(), &LayoutOf<ground_truth_t>(),
        &LayoutOf<service_status_t>(), &LayoutOf<model_t>(), &LayoutOf<baseline_model_t>(),
        &LayoutOf<environment_map_t>(), &LayoutOf<fall_alarm_t>(), &LayoutOf<fall_alarm_ack_t>()})
    Compare(*layout, structs, seen);
  for (const auto& [name, members] : structs)
    EXPECT_EQ(seen.count(name), 1u) << name << " has no layout";
}

}  // namespace
}  // namespace fallen::wire
