// A beam with a bar along its whole length: concrete below the bar, the bar, concrete above it.
// All lengths in the deck's unit; every parameter can be set from the deck.
DefineConstant[
  length = {400, Name "beam/length"},  // L
  depth = {100, Name "beam/depth"},    // h
  cover = {20, Name "bar/cover"},      // of concrete below the bar
  bar = {5, Name "bar/depth"}         // of the bar; it is as thick as the beam
];
top = cover + bar;

Point(1) = {0, 0, 0};
Point(2) = {length, 0, 0};
Point(3) = {length, cover, 0};
Point(4) = {length, top, 0};
Point(5) = {length, depth, 0};
Point(6) = {0, depth, 0};
Point(7) = {0, top, 0};
Point(8) = {0, cover, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 8};  // lower face of the bar
Line(4) = {8, 1};
Line(5) = {3, 4};
Line(6) = {4, 7};  // upper face
Line(7) = {7, 8};
Line(8) = {4, 5};
Line(9) = {5, 6};
Line(10) = {6, 7};
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {-3, 5, 6, 7};
Curve Loop(3) = {-6, 8, 9, 10};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Plane Surface(3) = {3};

Physical Surface("material:cover") = {1};
Physical Surface("material:steel") = {2};
Physical Surface("material:concrete") = {3};
