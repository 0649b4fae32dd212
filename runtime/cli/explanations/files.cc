// Explanations of the codes P50: the file as a whole.

#include "runtime/cli/explanations/explanations.h"

namespace plsc::cli {

namespace {

constexpr Explanation kFileRows[] = {
    {Code::kMissingVersion, ExampleKind::kGenotype,
     R"(A genotype file starts with the language that it is written in: 'plsc
1'. The version is a whole number.
)",
     R"(alphabet plasticoding 1
)",
     R"(plsc 1
alphabet plasticoding 1
)"},
    {Code::kNewerVersion, ExampleKind::kGenotype,
     R"(The file is written in a newer language than this program reads. Its
rules are not guessed at: use a newer plsc.
)",
     R"(plsc 2
alphabet plasticoding 1
)",
     R"(plsc 1
alphabet plasticoding 1
)"},
    {Code::kUnknownAlphabetVersion, ExampleKind::kGenotype,
     R"(The file asks for a version of the built-in alphabet that this program
does not have.
)",
     R"(plsc 1
alphabet plasticoding 2
)",
     R"(plsc 1
alphabet plasticoding 1
)"},
    {Code::kMergeConflict, ExampleKind::kGenotype,
     R"(git could not merge two versions of the file and left its markers in it.
Choose between the two sides and remove the markers.
)",
     R"(plsc 1
alphabet plasticoding 1
<<<<<<< HEAD
iterations 3
=======
iterations 4
>>>>>>> other
)",
     R"(plsc 1
alphabet plasticoding 1
iterations 4
)"},
    {Code::kNotUtf8, ExampleKind::kCommand,
     R"(The file is not UTF-8: it is UTF-16, or has letters of another encoding,
often in a comment. Save it as UTF-8, or convert it with iconv.
)",
     R"(plsc check latin1.pls
)",
     R"(plsc check robot.pls
)"},
    {Code::kAuthorsGenotype, ExampleKind::kGenotype,
     R"(The file is a genotype as Revolve, the authors' program, writes it:
Python, or lines of its own tokens. 'plsc import' translates it, rule by
rule. Revolve's joint AJ1 is the paper's A2 and AJ2 is A1; their
parameters are written in the order w, a, p, o. Revolve's clause
'hill == True' becomes 'if hill = True then'.
)",
     R"(C C addf B movef
B B addl ST_0.5
)",
     R"(plsc 1
alphabet plasticoding 1
rule C -> { C add_front B move_front }
rule B -> { B add_left T(0.5) }
)"},
    {Code::kEmptyFile, ExampleKind::kCommand,
     R"(The file has nothing in it, or only blanks.
)",
     R"(plsc check empty.pls
)",
     R"(plsc check robot.pls
)"},
    {Code::kUnreadableFile, ExampleKind::kCommand,
     R"(The file cannot be read; the message has the system's reason. '-' is
standard input.
)",
     R"(plsc check no_such_file.pls
)",
     R"(plsc check robot.pls
)"},
    {Code::kTooLargeFile, ExampleKind::kCommand,
     R"(Genotypes have some kilobytes. Files of more than 16 MiB are refused
before they are parsed: they are something else.
)",
     R"(plsc check large.pls
)",
     R"(plsc check robot.pls
)"},
    {Code::kNotText, ExampleKind::kCommand,
     R"(The file has zero bytes and so is no text: an image, an archive, a
program.
)",
     R"(plsc check picture.png
)",
     R"(plsc check robot.pls
)"},
};

}  // namespace

std::span<const Explanation> FileExplanations() {
  return kFileRows;
}

}  // namespace plsc::cli
