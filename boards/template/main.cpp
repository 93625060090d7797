#include "boards/template/board.hpp"
#include "firmware/run.hpp"

int main()
{
    kfast::board_template::Board board;
    kfast::run(board);
    return 0;
}
