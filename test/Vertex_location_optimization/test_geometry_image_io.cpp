// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of geometry images: byte by byte, and those that are none.

#include "check.h"
#include "test_images.h"

#include <CGAL/Geometry_image.h>
#include <CGAL/Simple_cartesian.h>

#ifdef __unix__
#include <sys/resource.h>

#include <csignal>
#endif

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

// an empty directory, removed at the end
class Directory
{
public:
  Directory() : m_path(fs::current_path() / "test_geometry_image_io")
  {
    fs::remove_all(m_path);
    fs::create_directory(m_path);
  }

  ~Directory()
  {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
  }

  std::string file(const std::string& name) const { return (m_path / name).string(); }

private:
  fs::path m_path;
};

void write_bytes(const std::string& name, const std::string& bytes) { std::ofstream(name, std::ios::binary) << bytes; }

std::string read_bytes(const std::string& name)
{
  std::ifstream is(name, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(is), {});
}

// the bytes of a 32 bit number from its bits, without regard to how this machine orders them
std::string bytes_of(std::uint32_t bits, bool is_little_endian)
{
  std::string bytes;
  for(int k = 0; k < 4; ++k)
    bytes += static_cast<char>(bits >> (8 * (is_little_endian ? k : 3 - k)) & 0xff);
  return bytes;
}

std::string bytes_of(float x, bool is_little_endian)
{
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bytes_of(bits, is_little_endian);
}

// the header of a .gim
std::string size_of_gim(std::int32_t width, std::int32_t height)
{
  return bytes_of(static_cast<std::uint32_t>(width), true) + bytes_of(static_cast<std::uint32_t>(height), true);
}

std::string samples(const std::vector<float>& coordinates, bool is_little_endian = true)
{
  std::string bytes;
  for(float x : coordinates)
    bytes += bytes_of(x, is_little_endian);
  return bytes;
}

// what f() writes to std::cerr
template <typename F>
std::string errors_of(const F& f)
{
  std::ostringstream errors;
  std::streambuf* buffer = std::cerr.rdbuf(errors.rdbuf());
  f();
  std::cerr.rdbuf(buffer);
  return errors.str();
}

// Checks that f(verbose) returns false, and that it tells about `name` and why if it shall.
template <typename F>
void check_fails(const std::string& name, const std::string& why, const F& f)
{
  bool result = true;
  CHECK_EQUAL(errors_of([&] { result = f(false); }), "");
  CHECK(!result);
  result = true;
  const std::string errors = errors_of([&] { result = f(true); });
  CHECK(!result);
  check::check(errors.find(name) != std::string::npos, __FILE__, __LINE__, "the message has the name", errors);
  check::check(errors.find(why) != std::string::npos, __FILE__, __LINE__, "the message says why", errors, why);
}

void check_unreadable(const Directory& directory, const std::string& name, const std::string& bytes, const std::string& why)
{
  const std::string file = directory.file(name);
  write_bytes(file, bytes);
  const Image before = open_patch(3, 2);
  Image image = before;
  check_fails(file, why,
              [&](bool verbose) { return CGAL::IO::read_geometry_image(file, image, CGAL::parameters::verbose(verbose)); });
  CHECK_EQUAL(errors_of([&] { CGAL::IO::read_geometry_image(file, image); }), ""); // by default
  CHECK(are_identical(image, before));
}

void check_unwritable(const std::string& file, const Image& image, const std::string& why)
{
  const std::string before = read_bytes(file);
  check_fails(file, why,
              [&](bool verbose) { return CGAL::IO::write_geometry_image(file, image, CGAL::parameters::verbose(verbose)); });
  CHECK_EQUAL(errors_of([&] { CGAL::IO::write_geometry_image(file, image); }), ""); // by default
  CHECK_EQUAL(read_bytes(file), before);
}

void test_bytes(const Directory& directory)
{
  const Image image = make_image(2, 3, [](std::size_t i, std::size_t j) { return Point(i, j + 0.5, -1e-3f); });
  const float z = -1e-3f;
  const std::vector<float> rows[] = { { 0, 0.5, z, 0, 1.5, z }, { 1, 0.5, z, 1, 1.5, z }, { 2, 0.5, z, 2, 1.5, z } };
  const std::string gim = size_of_gim(2, 3) + samples(rows[0]) + samples(rows[1]) + samples(rows[2]);
  auto pfm = [&](const std::string& header, bool is_little_endian) {
    return header + samples(rows[2], is_little_endian) + samples(rows[1], is_little_endian) +
           samples(rows[0], is_little_endian);
  };

  start_topic("Written files");
  CHECK(CGAL::IO::write_geometry_image(directory.file("a.gim"), image));
  CHECK_EQUAL(read_bytes(directory.file("a.gim")), gim);
  CHECK(CGAL::IO::write_geometry_image(directory.file("a.pfm"), image));
  CHECK_EQUAL(read_bytes(directory.file("a.pfm")), pfm("PF\n2 3\n-1\n", true));

  start_topic("Files that are read");
  auto check_read = [&](const std::string& name, const std::string& bytes) {
    write_bytes(directory.file(name), bytes);
    Image result = open_patch(4, 4);
    CHECK(CGAL::IO::read_geometry_image(directory.file(name), result, CGAL::parameters::verbose(true)));
    CHECK(are_identical(result, image));
  };
  check_read("b.gim", gim);
  check_read("b.GIM", gim);
  check_read("b.pfm", pfm("PF\n2 3\n-1.0\n", true));
  check_read("b.pfm", pfm("PF\n2 3\n1.0\n", false));
  check_read("b.pfm", pfm("PF 2 3 -0.5 ", true));
  check_read("b.PFM", pfm("PF\r\n2\t3\n 100\n", false));

  start_topic("There and back");
  const Image sphere = octahedral_sphere(17);
  for(const char* name : { "c.gim", "c.pfm" })
  {
    Image once, twice;
    CHECK(CGAL::IO::write_geometry_image(directory.file(name), sphere));
    CHECK(CGAL::IO::read_geometry_image(directory.file(name), once));
    CHECK(CGAL::IO::write_geometry_image(directory.file(name), once));
    CHECK(CGAL::IO::read_geometry_image(directory.file(name), twice));
    CHECK(are_identical(once, twice));
    for(std::size_t i = 0; i < 17; ++i)
      for(std::size_t j = 0; j < 17; ++j)
        CHECK_AT_MOST(norm(once(i, j) - sphere(i, j)), 1e-7);
    Mesh mesh;
    CGAL::geometry_image_to_polygon_mesh(once, mesh);
    CHECK(CGAL::is_closed(mesh));
  }
}

const std::string two(samples({ 1, 2, 3, 4, 5, 6 })); // samples

void test_bad_sizes(const Directory& directory)
{
  const std::int32_t large = (std::numeric_limits<std::int32_t>::max)();

  start_topic("Files that are too short or too long");
  for(std::size_t length = 0; length < 8 + two.size(); ++length)
    check_unreadable(directory, "short.gim", (size_of_gim(1, 2) + two).substr(0, length), "it ends");
  for(std::size_t length = 0; length < 10 + two.size(); ++length)
    check_unreadable(directory, "short.pfm", ("PF\n1 2\n-1\n" + two).substr(0, length), "");
  check_unreadable(directory, "short.pfm", "PF\n1 2\n-1\n" + two.substr(1), "it ends after 1 of 2");
  check_unreadable(directory, "long.gim", size_of_gim(1, 2) + two + " ", "more");
  check_unreadable(directory, "long.pfm", "PF\n1 2\n-1\n" + two + "\n", "more");

  start_topic("Sizes that are none");
  for(std::int32_t size : { 0, -1, -2, -large - 1 })
    for(const std::string& header : { size_of_gim(size, 2), size_of_gim(1, size), size_of_gim(size, size) })
      check_unreadable(directory, "size.gim", header + two, "size");
  for(const char* size : { "0 2", "1 0", "-1 -2", "1 -2", "4294967297 2", "2147483648 1", "1 9223372036854775807" })
    check_unreadable(directory, "size.pfm", "PF\n" + std::string(size) + "\n-1\n" + two, "size");
  check_unreadable(directory, "size.pfm", "PF\n99999999999999999999 1\n-1\n" + two, "header");

  start_topic("Sizes that are too large for the file, and for any machine");
  check_unreadable(directory, "large.gim", size_of_gim(large, large) + two, "it ends after 2");
  check_unreadable(directory, "large.gim", size_of_gim(65536, 65536) + two, "it ends after 2 of 4294967296");
  check_unreadable(directory, "large.gim", size_of_gim(1, large) + two, "it ends after 2");
  check_unreadable(directory, "large.pfm", "PF\n2147483647 2147483647\n-1\n" + two, "it ends after 2");
}

void test_bad_contents(const Directory& directory)
{
  start_topic("Coordinates that are not finite");
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = HUGE_VALF;
  for(float bad : { nan, -nan, infinity, -infinity })
    for(int k = 0; k < 6; ++k)
    {
      std::vector<float> coordinates(6, 1);
      coordinates[k] = bad;
      check_unreadable(directory, "bad.gim", size_of_gim(2, 1) + samples(coordinates), "finite");
      check_unreadable(directory, "bad.pfm", "PF\n2 1\n1\n" + samples(coordinates, false), "finite");
    }

  start_topic("Headers of other files");
  for(const char* magic : { "Pf", "P6", "pf", "PF4", "OFF", "", "\n", "P", "\x89PNG" })
    check_unreadable(directory, "magic.pfm", magic + ("\n1 2\n-1\n" + two), "");
  check_unreadable(directory, "magic.pfm", "Pf\n1 2\n-1\n" + two, "three channels");
  for(const char* header : { "x y\n-1\n", "1 2\n0\n", "1 2\nnan\n", "1 2\nx\n", "1.5 2\n-1\n", "1\n-1\n" })
    check_unreadable(directory, "header.pfm", "PF\n" + (header + two), "");
  check_unreadable(directory, "text.gim", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "");
}

void test_bad_files(const Directory& directory)
{
  start_topic("Files of another kind, and none");
  check_unreadable(directory, "image.png", size_of_gim(1, 2) + two, "extension");
  check_unreadable(directory, "image", size_of_gim(1, 2) + two, "extension");
  check_unreadable(directory, "image.", size_of_gim(1, 2) + two, "extension");
  fs::create_directory(directory.file("directory.gim"));
  Image untouched;
  for(const std::string& name : { directory.file("none.gim"), directory.file("directory.gim") })
    check_fails(name, "", [&](bool verbose) {
      return CGAL::IO::read_geometry_image(name, untouched, CGAL::parameters::verbose(verbose));
    });
  CHECK_EQUAL(untouched.width(), 0u);

  start_topic("Images that cannot be written leave the file as it is");
  for(const std::string& name : { directory.file("kept.gim"), directory.file("kept.pfm") })
  {
    write_bytes(name, "kept");
    check_unwritable(name, Image(), "size");
    check_unwritable(name, Image(0, 5), "size");
    for(double bad : { std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, 1e39 })
    {
      Image image(2, 2);
      image(1, 1) = Point(0, bad, 0);
      check_unwritable(name, image, "finite");
    }
  }
  check_unwritable(directory.file("image.off"), Image(2, 2), "extension");
  check_unwritable(directory.file("none/image.gim"), Image(2, 2), "opened");
  CHECK(!fs::exists(directory.file("image.off")));
}

#ifdef __unix__
void test_full_disk(const Directory& directory)
{
  start_topic("A disk that is full leaves what was there");
  using Image = CGAL::Geometry_image<CGAL::Simple_cartesian<double>::Point_3>;
  const std::string name = directory.file("full.gim");
  CHECK(CGAL::IO::write_geometry_image(name, Image(2, 3)));
  const std::string before = read_bytes(name);
  rlimit no_limit;
  getrlimit(RLIMIT_FSIZE, &no_limit);
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{ 4096, no_limit.rlim_max };
  setrlimit(RLIMIT_FSIZE, &limit);
  const bool is_written = CGAL::IO::write_geometry_image(name, Image(100, 100));
  setrlimit(RLIMIT_FSIZE, &no_limit);
  CHECK(!is_written);
  CHECK(read_bytes(name) == before);
  CHECK(!fs::exists(name + ".partial"));
  CHECK(CGAL::IO::write_geometry_image(name, Image(100, 100)));
  CHECK_EQUAL(fs::file_size(name), 8u + 12 * 100 * 100);
}
#endif

int main()
{
  const Directory directory;
  test_bytes(directory);
  test_bad_sizes(directory);
  test_bad_contents(directory);
  test_bad_files(directory);
#ifdef __unix__
  test_full_disk(directory);
#endif
  return test_result();
}
