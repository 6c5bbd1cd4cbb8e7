// A beam on two supports under two loads at the thirds of its span, cut at midspan by one straight ligament.
// All lengths in the deck's unit; every parameter can be set from the deck.
DefineConstant[
  depth = {100, Name "beam/depth"},            // h
  span = {300, Name "beam/span"},              // S, between the supports; the loads stand S/3 apart
  overhang = {50, Name "beam/overhang"},       // beyond each support
  ligament_size = {2, Name "mesh/ligament"},   // side of the triangles along the ligament
  far_size = {16, Name "mesh/far"}             // side of the triangles far from it
];
half = span / 2;
length = half + overhang;

Point(1) = {0, 0, 0, ligament_size};
Point(2) = {0, depth, 0, ligament_size};
Point(3) = {-half, 0, 0, far_size};
Point(4) = {-length, 0, 0, far_size};
Point(5) = {-length, depth, 0, far_size};
Point(6) = {-span / 6, depth, 0, far_size};   // load
Point(7) = {half, 0, 0, far_size};
Point(8) = {length, 0, 0, far_size};
Point(9) = {length, depth, 0, far_size};
Point(10) = {span / 6, depth, 0, far_size};   // load

Line(1) = {1, 2};                             // ligament
Line(2) = {1, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 2};
Line(7) = {1, 7};
Line(8) = {7, 8};
Line(9) = {8, 9};
Line(10) = {9, 10};
Line(11) = {10, 2};
Curve Loop(1) = {2, 3, 4, 5, 6, -1};
Curve Loop(2) = {7, 8, 9, 10, 11, -1};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Transfinite Curve {1} = Ceil(depth / ligament_size) + 1;

Physical Surface("material:concrete/left") = {1};
Physical Surface("material:concrete/right") = {2};
Physical Curve("interface:ligament") = {1};
