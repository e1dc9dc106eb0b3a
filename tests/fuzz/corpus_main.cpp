// fuzz-corpus FORMAT FOLDER: writes what a fuzzer begins with, the sound files of a format and 20
// damaged ones of each.
#include "tests/fuzz/mutation.h"
#include "tests/fuzz/seeds.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("fuzz-corpus FORMAT FOLDER\n", stderr);
        return 2;
    }
    const std::filesystem::path folder = argv[2];
    std::filesystem::create_directories(folder);
    const auto write = [&](const std::string& name, const std::string& bytes) {
        std::ofstream(folder / name, std::ios::binary)
            .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    };
    const std::vector<std::string> sound = vybeg::fuzz::sound_files(argv[1]);
    for (std::size_t i = 0; i < sound.size(); ++i) {
        write("sound-" + std::to_string(i), sound[i]);
    }
    for (std::uint64_t seed = 0; seed < 20 * sound.size(); ++seed) {
        write("damaged-" + std::to_string(seed), vybeg::fuzz::mutated(sound, seed).bytes);
    }
    return 0;
}
