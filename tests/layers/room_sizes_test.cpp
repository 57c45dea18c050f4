// SPDX-License-Identifier: Apache-2.0
// No room grows until nobody finds the way: at most 25 files on 6 floors. Oracle: the includes.
#include "tests/layers/room_sizes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/io/scratch_folder.hpp"

namespace torquewright::layers {
namespace {

constexpr std::size_t kMostFiles = 25;
constexpr std::size_t kMostFloors = 6;

/// A room that may be larger, up to what it is: it may shrink and not grow.
struct Exception {
  const char* room;
  std::size_t files;
  std::size_t floors;
  const char* reason;
};

constexpr const char* kLikeParts = "parts of one kind, a file each, of which a reader opens one";
constexpr Exception kExceptions[] = {
    {"actuator/effects", 36, 6, kLikeParts},
    {"actuator/exporters", 37, 4, kLikeParts},
    {"actuator/lint", 29, 8, kLikeParts},
};

const Exception* exception_of(const std::string& room) {
  const auto* found = std::find_if(std::begin(kExceptions), std::end(kExceptions),
                                   [&](const Exception& one) { return room == one.room; });
  return found == std::end(kExceptions) ? nullptr : found;
}

TEST(Rooms, AreNoLargerThanOneCanWalkThrough) {
  for (const RoomSize& size : room_sizes(TORQUEWRIGHT_SOURCE_DIR)) {
    const Exception* exception = exception_of(size.room);
    EXPECT_LE(size.files, exception != nullptr ? exception->files : kMostFiles)
        << size.room << ": split it, or move what it does not need";
    EXPECT_LE(size.floors, exception != nullptr ? exception->floors : kMostFloors)
        << size.room << ": so many files lean on one another";
  }
}

TEST(Rooms, NeedTheirExceptions) {
  for (const RoomSize& size : room_sizes(TORQUEWRIGHT_SOURCE_DIR)) {
    if (exception_of(size.room) == nullptr) continue;
    EXPECT_TRUE(size.files > kMostFiles || size.floors > kMostFloors)
        << size.room << " needs no exception any more";
  }
}

// A room of three files of which each includes the next, one of them with a header and a source.
TEST(Rooms, CountFilesAndFloorsOfATree) {
  const test::ScratchFolder folder;
  std::filesystem::create_directories(folder.path() / "actuator" / "motor");
  folder.write("actuator/motor/top.cpp", "#include \"actuator/motor/middle.hpp\"\n");
  folder.write("actuator/motor/middle.hpp", "#include \"actuator/motor/ground.hpp\"\n");
  folder.write("actuator/motor/middle.cpp", "#include \"actuator/motor/middle.hpp\"\n");
  folder.write("actuator/motor/ground.hpp", "#include <vector>\n");
  const std::vector<RoomSize> sizes = room_sizes(folder.path());
  ASSERT_EQ(sizes.size(), 1u);
  EXPECT_EQ(sizes[0].room, "actuator/motor");
  EXPECT_EQ(sizes[0].files, 3u);
  EXPECT_EQ(sizes[0].floors, 3u);
}

}  // namespace
}  // namespace torquewright::layers
