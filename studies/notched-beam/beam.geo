// A notched beam on two supports. The notch has no width: left and right half have lips of their own.
// All lengths in the deck's unit; every parameter can be set from the deck.
DefineConstant[
  depth = {100, Name "beam/depth"},            // D
  span = {400, Name "beam/span"},              // S, between the supports
  notch = {50, Name "beam/notch"},             // a0
  overhang = {20, Name "beam/overhang"},       // beyond each support
  ligament_size = {2.5, Name "mesh/ligament"}, // side of the triangles along the ligament
  far_size = {12, Name "mesh/far"}             // side of the triangles far from it
];
half = span / 2;
length = half + overhang;

Point(1) = {0, notch, 0, ligament_size};      // tip
Point(2) = {0, depth, 0, ligament_size};      // top of the ligament
Point(3) = {0, 0, 0, ligament_size};          // mouth, left lip
Point(4) = {0, 0, 0, ligament_size};          // mouth, right lip
Point(5) = {-half, 0, 0, far_size};
Point(6) = {half, 0, 0, far_size};
Point(7) = {-length, depth, 0, far_size};
Point(8) = {length, depth, 0, far_size};

Line(1) = {1, 2};                             // ligament
Line(2) = {3, 1};                             // left lip
Line(3) = {4, 1};                             // right lip
Line(4) = {5, 3};
Line(5) = {4, 6};
Line(6) = {2, 7};
Line(7) = {8, 2};
If (overhang > 0)
  Point(9) = {-length, 0, 0, far_size};
  Point(10) = {length, 0, 0, far_size};
  Line(8) = {7, 9};
  Line(9) = {10, 8};
  Line(10) = {9, 5};
  Line(11) = {6, 10};
  Curve Loop(1) = {2, 1, 6, 8, 10, 4};
  Curve Loop(2) = {5, 11, 9, 7, -1, -3};
Else
  Line(8) = {7, 5};
  Line(9) = {6, 8};
  Curve Loop(1) = {2, 1, 6, 8, 4};
  Curve Loop(2) = {5, 9, 7, -1, -3};
EndIf
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Transfinite Curve {1} = Ceil((depth - notch) / ligament_size) + 1;

Physical Surface("material:concrete/left") = {1};
Physical Surface("material:concrete/right") = {2};
Physical Curve("interface:ligament") = {1};
Physical Curve("slit:notch") = {2, 3};
