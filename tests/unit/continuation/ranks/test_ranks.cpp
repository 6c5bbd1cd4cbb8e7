#include <gtest/gtest.h>

#include <string>

#include "continuation/ranks/ranks.hpp"

namespace dda {
namespace {

Answer adding(double own) {
  return [own](Message& request) {
    Message reply;
    reply.put(own + request.take<double>());
    return reply;
  };
}

std::optional<Message> number(double value) {
  Message out;
  out.put(value);
  return out;
}

TEST(Message, GivesBackWhatWasPutInInThatOrder) {
  Message message;
  message.put(3);
  const std::vector<double> values{1, 2.5};
  message.put_all<double>(values);
  message.put('x');
  Message arrived(message.bytes());
  EXPECT_EQ(arrived.take<int>(), 3);
  EXPECT_EQ(arrived.take_all<double>(), values);
  EXPECT_EQ(arrived.take<char>(), 'x');
}

TEST(Message, ThatIsTooShortIsNotReadBeyondItsEnd) {
  Message message;
  message.put(std::size_t{1000});
  EXPECT_THROW(message.take_all<double>(), std::logic_error);
  EXPECT_THROW(message.take<double>(), std::logic_error);
}

TEST(Ranks, RepliesComeInTheirOrder) {
  Ranks ranks = Ranks::here({adding(10), adding(20), adding(30)});
  std::vector<std::size_t> order;
  std::vector<double> replies;
  ranks.exchange([](std::size_t rank) { return number(static_cast<double>(rank)); },
                 [&](std::size_t rank, Message& reply) {
                   order.push_back(rank);
                   replies.push_back(reply.take<double>());
                 });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(replies, (std::vector<double>{10, 21, 32}));
}

TEST(Ranks, ThoseThatAreNotAskedDoNotReply) {
  Ranks ranks = Ranks::here({adding(10), adding(20)});
  int replies = 0;
  ranks.exchange([](std::size_t rank) { return rank == 1 ? number(1) : std::nullopt; },
                 [&](std::size_t rank, Message&) {
                   EXPECT_EQ(rank, 1u);
                   ++replies;
                 });
  EXPECT_EQ(replies, 1);
}

TEST(Ranks, AFailureIsToldWhenAllOthersHaveReplied) {
  Ranks ranks = Ranks::here({[](Message&) -> Message { throw std::runtime_error("no room"); }, adding(20)});
  int replies = 0;
  const auto ask = [&] {
    ranks.exchange([](std::size_t) { return number(1); }, [&](std::size_t, Message&) { ++replies; });
  };
  try {
    ask();
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "no room");
  }
  EXPECT_EQ(replies, 1);
}

}  // namespace
}  // namespace dda
