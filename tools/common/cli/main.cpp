// SPDX-License-Identifier: BSD-3-Clause
// The program of a tool. Its own main() has another name, so that several tools can be one program.
int SMURF_TOOL_MAIN(int argc, char** argv);

int main(int argc, char** argv) { return SMURF_TOOL_MAIN(argc, argv); }
