# For Homebrew. Not tested here: it was written from the list of packages that CMakeLists.txt looks for.
class SmurfTools < Formula
  desc "@SUMMARY@"
  homepage "@HOMEPAGE@"
  url "@SOURCE@"
  sha256 "@SHA256@"
  license "BSD-3-Clause"

  depends_on "cmake" => :build
  depends_on "eigen" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "pkgconf" => :build
  depends_on "console_bridge"
  depends_on "minizip"
  depends_on "tinyxml2"
  depends_on "urdfdom"
  depends_on "urdfdom_headers"
  depends_on "yaml-cpp"
  depends_on "zlib"

  def install
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja",
           "-DSMURF_BUILD_TESTS=OFF", "-DSMURF_BUILD_PYTHON=OFF", *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    (testpath/"robot.urdf").write '<robot name="r"><link name="a"/></robot>'
    system bin/"smurf-lint", "robot.urdf"
  end
end
