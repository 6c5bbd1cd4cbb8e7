// A beam on two supports whose crack can only run straight up at midspan, from a notch without width or from the
// bottom. All lengths in the deck's unit; every parameter can be set from the deck.
DefineConstant[
  depth = {100, Name "beam/depth"},            // D
  span = {400, Name "beam/span"},              // S, between the supports
  notch = {0, Name "beam/notch"},              // a0; 0 for none
  arm = {0, Name "beam/arm"},                  // of each load from midspan; 0 for one load there
  overhang = {20, Name "beam/overhang"},       // beyond each support
  ligament_size = {2, Name "mesh/ligament"},   // side of the triangles along the ligament
  far_size = {16, Name "mesh/far"}             // side of the triangles far from it
];
half = span / 2;
length = half + overhang;

Point(1) = {0, notch, 0, ligament_size};       // tip
Point(2) = {0, depth, 0, ligament_size};       // top of the ligament
Point(3) = {-half, 0, 0, far_size};
Point(4) = {half, 0, 0, far_size};
Point(5) = {-length, 0, 0, far_size};
Point(6) = {length, 0, 0, far_size};
Point(7) = {-length, depth, 0, far_size};
Point(8) = {length, depth, 0, far_size};

Line(1) = {1, 2};                              // ligament
Line(2) = {5, 3};
Line(3) = {4, 6};
Line(4) = {7, 5};
Line(5) = {6, 8};
Transfinite Curve {1} = Ceil((depth - notch) / ligament_size) + 1;
Physical Curve("interface:ligament") = {1};

If (notch > 0)
  Point(9) = {0, 0, 0, ligament_size};         // mouth, left lip
  Point(10) = {0, 0, 0, ligament_size};        // mouth, right lip
  Line(6) = {3, 9};
  Line(7) = {9, 1};
  Line(8) = {1, 10};
  Line(9) = {10, 4};
  Physical Curve("slit:notch") = {7, 8};
  bottom_left[] = {6, 7};
  bottom_right[] = {8, 9};
Else
  Line(6) = {3, 1};
  Line(7) = {1, 4};
  bottom_left[] = {6};
  bottom_right[] = {7};
EndIf

If (arm > 0)
  Point(11) = {-arm, depth, 0, far_size};
  Point(12) = {arm, depth, 0, far_size};
  Line(10) = {2, 11};
  Line(11) = {11, 7};
  Line(12) = {8, 12};
  Line(13) = {12, 2};
  top_left[] = {10, 11};
  top_right[] = {12, 13};
Else
  Line(10) = {2, 7};
  Line(11) = {8, 2};
  top_left[] = {10};
  top_right[] = {11};
EndIf

Curve Loop(1) = {2, bottom_left[], 1, top_left[], 4};
Curve Loop(2) = {bottom_right[], 3, 5, top_right[], -1};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Physical Surface("material:concrete/left") = {1};
Physical Surface("material:concrete/right") = {2};
