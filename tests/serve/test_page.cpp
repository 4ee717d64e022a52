// The files that may be served, and where they are found.

#include <gtest/gtest.h>

#include <leadscrew/serve/page.hpp>

#include "folder.hpp"

namespace leadscrew::serve {
namespace test_page {

TEST(Page, HasTheFilesBelowItsFolderByTheirPaths) {
  const PageFolder folder;
  const auto page = Page::read(folder.page());
  ASSERT_TRUE(page);
  ASSERT_NE(page->find("/"), nullptr);
  EXPECT_EQ(page->find("/"), page->find("/index.html"));
  EXPECT_EQ(page->find("/assets/code.js")->text, "let x;");
  EXPECT_EQ(page->find("/assets/code.js")->type, "text/javascript; charset=utf-8");
  EXPECT_EQ(page->find("/assets/engine.wasm")->type, "application/wasm");
  for (const char* other : {"", "index.html", "//index.html", "/assets", "/assets/", "/assets/../index.html",
                            "/./index.html", "/../secret", "/assets/../../secret"})
    EXPECT_EQ(page->find(other), nullptr) << other;
}

TEST(Page, FollowsNoLinkOutOfItsFolderNorInIt) {
  const PageFolder folder;
  std::filesystem::create_symlink("../secret", folder.page() / "file");
  std::filesystem::create_directory_symlink("..", folder.page() / "up");
  std::filesystem::create_symlink("index.html", folder.page() / "same.html");
  const auto page = Page::read(folder.page());
  ASSERT_TRUE(page);
  for (const char* link : {"/file", "/up/secret", "/up", "/same.html"}) EXPECT_EQ(page->find(link), nullptr) << link;
}

TEST(Page, IsMarkedWhereAMachineCanBeWatched) {
  const PageFolder folder;
  auto page = Page::read(folder.page());
  ASSERT_TRUE(page);
  page->mark_live();
  EXPECT_NE(page->find("/")->text.find("<head><meta name=\"leadscrew-live\""), std::string::npos);
  EXPECT_EQ(page->find("/assets/code.js")->text, "let x;");
}

TEST(Page, OfNoPageIsSaid) {
  const PageFolder folder;
  EXPECT_EQ(Page::read(folder.path / "none").error().code, "io-open");
  EXPECT_EQ(Page::read(folder.path / "page/assets").error().code, "io-no-page");
  EXPECT_EQ(page_folder(folder.path).error().code, "io-no-page");
  for (int file = 0; file <= static_cast<int>(Page::most_files); ++file)
    folder.write("page/many/" + std::to_string(file), "");
  EXPECT_EQ(Page::read(folder.page()).error().code, "input-too-large");
}

TEST(Page, IsFoundBesideTheCommandWhereItIsInstalled) {
  const PageFolder folder;
  folder.write("share/leadscrew/web/index.html", "");
  const auto found = page_folder(folder.path / "bin");
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, folder.path / "share/leadscrew/web");
}

}  // namespace test_page
}  // namespace leadscrew::serve
