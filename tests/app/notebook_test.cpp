#include "app/notebook.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "support/program.h"

namespace cleave::test {
namespace {

using nlohmann::json;

class NotebookOf : public testing::Test {
  protected:
    TemporaryFolder folder_;
    const std::filesystem::path file_ = folder_ / "unfinished.jsonl";
    const json run_{{"program", "1.0"}, {"runs", 5}};
    int measured_ = 0;

    int measure(Notebook& notebook, const std::string& name, int value) {
        return notebook.once(name, [&] {
            ++measured_;
            return value;
        });
    }
};

TEST_F(NotebookOf, MeasuresOnceInARun) {
    Notebook notebook(file_, run_);
    EXPECT_EQ(notebook.takenOver(), 0u);
    EXPECT_EQ(measure(notebook, "a", 1), 1);
    EXPECT_EQ(measure(notebook, "a", 2), 1);
    EXPECT_EQ(measure(notebook, "b", 3), 3);
    EXPECT_EQ(measured_, 2);
}

TEST_F(NotebookOf, GoesOnInTheNextRun) {
    {
        Notebook first(file_, run_);
        measure(first, "a", 1);
    }
    Notebook second(file_, run_);
    EXPECT_EQ(second.takenOver(), 1u);
    EXPECT_EQ(measure(second, "a", 2), 1);
    EXPECT_EQ(measure(second, "b", 3), 3);
    Notebook third(file_, run_);
    EXPECT_EQ(third.takenOver(), 2u) << "what the second had taken over stays";
}

TEST_F(NotebookOf, AnotherRunStartsAnew) {
    {
        Notebook first(file_, run_);
        measure(first, "a", 1);
    }
    Notebook other(file_, {{"program", "1.0"}, {"runs", 6}});
    EXPECT_EQ(other.takenOver(), 0u);
    EXPECT_EQ(measure(other, "a", 2), 2);
}

TEST_F(NotebookOf, ALineThatWasCutShortIsNotThere) {
    {
        Notebook first(file_, run_);
        measure(first, "a", 1);
        measure(first, "b", 2);
    }
    const std::string whole = contentOf(file_);
    for (size_t cut = 1; cut < 20; ++cut) {
        put(file_, whole.substr(0, whole.size() - 1 - cut));
        Notebook second(file_, run_);
        EXPECT_EQ(second.takenOver(), 1u) << cut << " bytes less";
        EXPECT_EQ(measure(second, "b", 3), 3);
    }
}

TEST_F(NotebookOf, FiguresOfAnotherKindAreMeasuredAnew) {
    put(file_, run_.dump() + "\n{\"name\":\"a\",\"figure\":\"text\"}\n{\"name\":7,\"figure\":1}\n");
    Notebook notebook(file_, run_);
    EXPECT_EQ(measure(notebook, "a", 4), 4);
}

TEST_F(NotebookOf, IsGoneWhenTheRunIsComplete) {
    Notebook notebook(file_, run_);
    measure(notebook, "a", 1);
    notebook.remove();
    EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(NotebookOf, SaysThatItCannotBeWritten) {
    EXPECT_THROW(Notebook(folder_ / "no/such", run_), Error);
    EXPECT_THROW(Notebook("/dev/full", run_), Error);
}

}  // namespace
}  // namespace cleave::test
