// The head of a bolt in concrete. Its shaft is left out: concrete stands in its place, or a slot if `shaft` is given.
// The origin is the centre of the head, the surface is above. All lengths in the deck's unit; every parameter can be
// set from the deck.
DefineConstant[
  width = {400, Name "concrete/width"},
  depth = {300, Name "concrete/depth"},
  embedment = {50, Name "head/embedment"},   // from the surface to the bearing face of the head
  head_width = {40, Name "head/width"},
  head_depth = {20, Name "head/depth"},
  shaft = {0, Name "head/shaft"},            // width of a slot in the place of the shaft
  support = {60, Name "support/distance"},  // from the axis to the middle of a support
  plate = {20, Name "support/width"}
];
half = width / 2;
head = head_width / 2;
slot = shaft / 2;
bearing = head_depth / 2;
surface = bearing + embedment;
inner = support - plate / 2;
outer = support + plate / 2;

Point(1) = {-half, surface - depth, 0};
Point(2) = {half, surface - depth, 0};
Point(3) = {half, surface, 0};
Point(4) = {outer, surface, 0};
Point(5) = {inner, surface, 0};
Point(6) = {-inner, surface, 0};
Point(7) = {-outer, surface, 0};
Point(8) = {-half, surface, 0};
Point(9) = {head, bearing, 0};
Point(10) = {head, -bearing, 0};
Point(11) = {-head, -bearing, 0};
Point(12) = {-head, bearing, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};    // right support
Line(5) = {6, 7};    // left support
Line(6) = {7, 8};
Line(7) = {8, 1};
Line(8) = {9, 10};
Line(9) = {10, 11};
Line(10) = {11, 12};

If (shaft > 0)
  Point(13) = {slot, surface, 0};
  Point(14) = {slot, bearing, 0};
  Point(15) = {-slot, bearing, 0};
  Point(16) = {-slot, surface, 0};
  Line(11) = {5, 13};
  Line(12) = {13, 14};
  Line(13) = {14, 9};   // bearing face, right
  Line(14) = {12, 15};  // left
  Line(15) = {15, 16};
  Line(16) = {16, 6};
  Line(17) = {15, 14};
  Curve Loop(1) = {1, 2, 3, 4, 11, 12, 13, 8, 9, 10, 14, 15, 16, 5, 6, 7};
  Curve Loop(2) = {-10, -9, -8, -13, -17, -14};
  Plane Surface(1) = {1};
Else
  Line(11) = {5, 6};
  Line(12) = {12, 9};   // bearing face
  Curve Loop(1) = {1, 2, 3, 4, 11, 5, 6, 7};
  Curve Loop(2) = {-10, -9, -8, -12};
  Plane Surface(1) = {1, 2};
EndIf
Plane Surface(2) = {2};

Physical Surface("material:concrete") = {1};
Physical Surface("material:steel/head") = {2};
Physical Curve("boundary:supports") = {4, 5};
