// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/picture/film_writer.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace fallen {
namespace {

std::vector<std::string> FfmpegCommand(const std::filesystem::path& film, int width, int height,
                                       double rate) {
  return {"ffmpeg",
          "-y",
          "-loglevel",
          "error",
          "-f",
          "rawvideo",
          "-pixel_format",
          "bgr0",
          "-video_size",
          fmt::format("{}x{}", width, height),
          "-framerate",
          fmt::format("{}", rate),
          "-i",
          "-",
          "-c:v",
          "libx264",
          "-preset",
          "veryfast",
          "-crf",
          "20",
          "-pix_fmt",
          "yuv420p",
          "-movflags",
          "+faststart",
          "-f",
          "mp4",
          film.string()};
}

/// Starts `command` with `input` as its standard input.
pid_t Spawn(std::vector<std::string> command, int input) {
  std::vector<char*> argv;
  for (std::string& word : command) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  pid_t child = -1;
  const int error = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    throw std::runtime_error(command[0] + ": " + std::strerror(error) +
                             ", expected the program: apt-get install ffmpeg");
  return child;
}

}  // namespace

FilmWriter::FilmWriter(const std::filesystem::path& film, int width, int height,
                       double pictures_per_second)
    : file_(film) {
  std::signal(SIGPIPE, SIG_IGN);  // that ffmpeg gave up is told by Add
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to ffmpeg");
  pipe_ = ends[1];
  try {
    ffmpeg_ = Spawn(FfmpegCommand(file_.path(), width, height, pictures_per_second), ends[0]);
  } catch (...) {
    close(ends[0]);
    close(pipe_);
    throw;
  }
  close(ends[0]);
}

FilmWriter::~FilmWriter() {
  if (ffmpeg_ > 0) WaitForEnd();
}

void FilmWriter::Add(std::span<const std::uint32_t> pixels) {
  const auto bytes = std::as_bytes(pixels);
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = write(pipe_, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw std::runtime_error("ffmpeg has given up on the film");
    done += static_cast<std::size_t>(written);
  }
}

int FilmWriter::WaitForEnd() {
  close(pipe_);
  int status = -1;
  waitpid(ffmpeg_, &status, 0);
  ffmpeg_ = -1;
  return status;
}

void FilmWriter::Close() {
  if (WaitForEnd() != 0) throw std::runtime_error("ffmpeg could not make the film");
  file_.Commit();
}

}  // namespace fallen
