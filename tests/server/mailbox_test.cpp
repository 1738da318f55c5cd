#include "chunks/mailbox.h"

#include <catch2/catch.hpp>
#include <new>

using namespace talus::server;

namespace {

HeightsReady mail(std::uint64_t ticket) {
  return {ticket, HeightsResult{}};
}

std::vector<std::uint64_t> tickets(const std::vector<Mail>& mail) {
  std::vector<std::uint64_t> tickets;
  for (const Mail& each : mail) tickets.push_back(std::get<HeightsReady>(each).ticket);
  return tickets;
}

}  // namespace

TEST_CASE("mail is taken all at once, oldest first") {
  Mailbox box{ClientId{1}, [] {}};
  for (std::uint64_t ticket = 1; ticket <= 3; ++ticket) box.put(mail(ticket));
  CHECK(tickets(box.take()) == std::vector<std::uint64_t>{1, 2, 3});
  CHECK(box.take().empty());
}

TEST_CASE("an owner is woken for mail alone, and not again before it took it") {
  int woken = 0;
  Mailbox box{ClientId{1}, [&] { ++woken; }};
  box.wake();
  CHECK(woken == 0);
  box.put(mail(1));
  CHECK(woken == 0);
  box.wake();
  box.put(mail(2));
  box.wake();
  CHECK(woken == 1);
  (void)box.take();
  box.wake();
  CHECK(woken == 1);
  box.put(mail(3));
  box.wake();
  CHECK(woken == 2);
}

TEST_CASE("an owner whose only mail is lost is woken to notice") {
  bool fails = false;
  int woken = 0;
  Mailbox box{ClientId{1}, [&] {
                if (fails) throw std::bad_alloc{};
                ++woken;
              }};
  box.lose_mail();
  CHECK(woken == 1);
  CHECK(box.has_lost());
  CHECK(box.take().empty());
  fails = true;
  box.lose_mail();
  CHECK(woken == 1);
  fails = false;
  box.wake();
  CHECK(woken == 2);
}

TEST_CASE("an owner that could not be woken is woken by the next sender, and loses no mail") {
  bool fails = true;
  int woken = 0;
  Mailbox box{ClientId{1}, [&] {
                if (fails) throw std::bad_alloc{};
                ++woken;
              }};
  box.put(mail(1));
  CHECK_THROWS_AS(box.wake(), std::bad_alloc);
  fails = false;
  box.wake();
  CHECK(woken == 1);
  CHECK(tickets(box.take()) == std::vector<std::uint64_t>{1});
}

namespace {

ChunkChangesPtr changes(std::size_t count) {
  return std::make_shared<const std::vector<ChunkChange>>(count);
}

}  // namespace

TEST_CASE("changes that pile up become one that may be of any chunk, among the other mail") {
  Mailbox mailbox{ClientId{1}, [] {}};
  mailbox.put(QueueHasRoom{});
  const ChunkChangesPtr half = changes(Mailbox::kMaxChanges / 2);
  mailbox.put_changes(half);
  mailbox.put_changes(half);
  mailbox.put(HeightsReady{1, {}});
  SECTION("as many as there may be") {
    const auto mail = mailbox.take();
    REQUIRE(mail.size() == 4);
    CHECK(std::get<ChunksChanged>(mail[1]).changes == half);
  }
  SECTION("one more, and whatever comes then") {
    mailbox.put_changes(changes(1));
    for (int i = 0; i < 100; ++i) mailbox.put_changes(half);
    const auto mail = mailbox.take();
    REQUIRE(mail.size() == 3);
    CHECK(std::holds_alternative<QueueHasRoom>(mail[0]));
    CHECK(std::holds_alternative<HeightsReady>(mail[1]));
    CHECK(std::get<ChunksChanged>(mail[2]).changes == nullptr);
  }
  mailbox.put_changes(half);  // once they are taken it begins anew
  CHECK(std::get<ChunksChanged>(mailbox.take().at(0)).changes == half);
}
