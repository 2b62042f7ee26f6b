<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>ClipTool</name>
    <message>
        <source>Crop</source>
        <translation>Rogner</translation>
    </message>
    <message>
        <source>Move the clip plane</source>
        <translation>Déplacer le plan de découpe</translation>
    </message>
    <message>
        <source>Tilt the clip plane</source>
        <translation>Incliner le plan de découpe</translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Menu: %1</source>
        <translation>Menu&#xa0;: %1</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Touches et souris</translation>
    </message>
    <message>
        <source>What the mouse does in each view, then the keys of the menus.</source>
        <translation>Ce que fait la souris dans chaque vue, puis les touches des menus.</translation>
    </message>
    <message>
        <source>not available</source>
        <translation>indisponibles</translation>
    </message>
    <message>
        <source> (shader schedule: %1)</source>
        <translation> (ordonnancement des shaders&#xa0;: %1)</translation>
    </message>
    <message>
        <source>About Fenestra</source>
        <translation>À propos de Fenestra</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Fenestra %1&lt;/h3&gt;&lt;p&gt;A medical volume viewer that opens an adaptive cutaway around the structure you want to see.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Not for diagnostic use.&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. It comes with no warranty.&lt;/p&gt;&lt;p&gt;3-D views: %2&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Fenestra %1&lt;/h3&gt;&lt;p&gt;Une visionneuse de volumes médicaux qui ouvre un écorché adaptatif autour de la structure à voir.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ne pas utiliser pour le diagnostic.&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Logiciel libre sous licence publique générale GNU, version 3 ou ultérieure. Sans aucune garantie.&lt;/p&gt;&lt;p&gt;Vues 3D&#xa0;: %2&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Coupes</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Clic</translation>
    </message>
    <message>
        <source>crosshair; the label there, or the region around the place, becomes the focus</source>
        <translation>réticule&#xa0;; l&apos;étiquette à cet endroit, ou la région autour, devient la cible</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Ctrl+clic</translation>
    </message>
    <message>
        <source>the label joins or leaves the focus</source>
        <translation>l&apos;étiquette rejoint ou quitte la cible</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Glisser</translation>
    </message>
    <message>
        <source>window width (across) and level (up and down)</source>
        <translation>largeur de fenêtre (horizontal) et niveau (vertical)</translation>
    </message>
    <message>
        <source>Ctrl+double-click</source>
        <translation>Ctrl+double clic</translation>
    </message>
    <message>
        <source>window and level of the data</source>
        <translation>fenêtrage des données</translation>
    </message>
    <message>
        <source>Wheel, arrows</source>
        <translation>Molette, flèches</translation>
    </message>
    <message>
        <source>next and previous slices</source>
        <translation>coupes suivantes et précédentes</translation>
    </message>
    <message>
        <source>Page up, Page down</source>
        <translation>Page préc., Page suiv.</translation>
    </message>
    <message>
        <source>ten slices</source>
        <translation>dix coupes</translation>
    </message>
    <message>
        <source>Measures, on the slices</source>
        <translation>Mesures, sur les coupes</translation>
    </message>
    <message>
        <source>Drag, or clicks</source>
        <translation>Glisser ou clics</translation>
    </message>
    <message>
        <source>Drag a handle or line</source>
        <translation>Glisser une poignée ou ligne</translation>
    </message>
    <message>
        <source>move the end, or the measure</source>
        <translation>déplacer l&apos;extrémité ou la mesure</translation>
    </message>
    <message>
        <source>Right click on it</source>
        <translation>Clic droit dessus</translation>
    </message>
    <message>
        <source>Clipping, while its tab is in sight</source>
        <translation>Découpe, tant que son onglet est visible</translation>
    </message>
    <message>
        <source>Drag a square</source>
        <translation>Glisser un carré</translation>
    </message>
    <message>
        <source>move a face of the box, or a plane</source>
        <translation>déplacer une face de la boîte ou un plan</translation>
    </message>
    <message>
        <source>Drag the ball at an arrow</source>
        <translation>Glisser la boule d&apos;une flèche</translation>
    </message>
    <message>
        <source>tilt the plane</source>
        <translation>incliner le plan</translation>
    </message>
    <message>
        <source>Walls of slices, in the 3-D views</source>
        <translation>Parois de coupes, dans les vues 3D</translation>
    </message>
    <message>
        <source>move the slice of that colour</source>
        <translation>déplacer la coupe de cette couleur</translation>
    </message>
    <message>
        <source>3-D views</source>
        <translation>Vues 3D</translation>
    </message>
    <message>
        <source>Drag, arrows</source>
        <translation>Glisser, flèches</translation>
    </message>
    <message>
        <source>rotate; the linked view follows</source>
        <translation>tourner&#xa0;; la vue liée suit</translation>
    </message>
    <message>
        <source>crosshair to what is seen there; its label or region becomes the focus</source>
        <translation>réticule sur ce qu&apos;on y voit&#xa0;; son étiquette ou sa région devient la cible</translation>
    </message>
    <message>
        <source>its label joins or leaves the focus</source>
        <translation>son étiquette rejoint ou quitte la cible</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Molette</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>zoom</translation>
    </message>
    <message>
        <source>A grown region, in all views</source>
        <translation>Région obtenue par croissance, dans toutes les vues</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Maj+clic</translation>
    </message>
    <message>
        <source>add what is there to the region</source>
        <translation>ajouter à la région ce qui s&apos;y trouve</translation>
    </message>
    <message>
        <source>take what is there away from the region</source>
        <translation>retirer de la région ce qui s&apos;y trouve</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Maj+glisser</translation>
    </message>
    <message>
        <source>draw a ball around a structure: the region that grows there stays within it</source>
        <translation>tracer une boule autour d&apos;une structure&#xa0;: la région qui y croît reste dedans</translation>
    </message>
    <message>
        <source>Alt+wheel</source>
        <translation>Alt+molette</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>tolérance</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>open the 3-D views to a large or doubtful region, which asks before</source>
        <translation>ouvrir les vues 3D vers une région grande ou douteuse, qui demande avant</translation>
    </message>
    <message>
        <source>Painting the region, in all views</source>
        <translation>Peindre la région, dans toutes les vues</translation>
    </message>
    <message>
        <source>add what the ball passes over</source>
        <translation>ajouter ce que la boule parcourt</translation>
    </message>
    <message>
        <source>take it away</source>
        <translation>le retirer</translation>
    </message>
    <message>
        <source>Brush, in the 3-D views</source>
        <translation>Pinceau, dans les vues 3D</translation>
    </message>
    <message>
        <source>paint</source>
        <translation>peindre</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Ctrl+glisser</translation>
    </message>
    <message>
        <source>rotate</source>
        <translation>tourner</translation>
    </message>
    <message>
        <source>Shift+wheel, Shift+drag</source>
        <translation>Maj+molette, Maj+glisser</translation>
    </message>
    <message>
        <source>depth, or by how much the context&apos;s edges change</source>
        <translation>profondeur, ou de combien changent les arêtes du contexte</translation>
    </message>
    <message>
        <source>Carving, in all views</source>
        <translation>Sculpture, dans toutes les vues</translation>
    </message>
    <message>
        <source>remove what lies along it, once the button is let go</source>
        <translation>enlever ce qui se trouve le long du tracé, au relâchement</translation>
    </message>
    <message>
        <source>bend the plane that was laid last</source>
        <translation>courber le dernier plan posé</translation>
    </message>
    <message>
        <source>A transfer function</source>
        <translation>Fonction de transfert</translation>
    </message>
    <message>
        <source>Drag a point, or a trapezoid&apos;s edge, top or inside</source>
        <translation>Glisser un point, ou le bord, le haut ou l&apos;intérieur d&apos;un trapèze</translation>
    </message>
    <message>
        <source>move it; with Shift across or up and down alone; Esc takes it back</source>
        <translation>le déplacer&#xa0;; avec Maj, horizontalement ou verticalement seulement&#xa0;; Échap annule</translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation>Double clic</translation>
    </message>
    <message>
        <source>add a point, or choose the colour of the point there</source>
        <translation>ajouter un point, ou choisir la couleur de celui-ci</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Clic droit</translation>
    </message>
    <message>
        <source>colour, delete, and add a point or a trapezoid</source>
        <translation>couleur, suppression, ajout d&apos;un point ou d&apos;un trapèze</translation>
    </message>
    <message>
        <source>Wheel, middle drag</source>
        <translation>Molette, glisser avec le bouton central</translation>
    </message>
    <message>
        <source>enlarge the values, and move along them</source>
        <translation>agrandir les valeurs et s&apos;y déplacer</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Flèches</translation>
    </message>
    <message>
        <source>move the point; with Shift ten times as far, with Alt its whole trapezoid</source>
        <translation>déplacer le point&#xa0;; avec Maj dix fois plus, avec Alt tout son trapèze</translation>
    </message>
    <message>
        <source>Page up, Page down, Home, End</source>
        <translation>Page préc., Page suiv., Début, Fin</translation>
    </message>
    <message>
        <source>choose another point</source>
        <translation>choisir un autre point</translation>
    </message>
    <message>
        <source>Ins, Del, Return</source>
        <translation>Inser, Suppr, Entrée</translation>
    </message>
    <message>
        <source>add a point, delete the point, choose its colour</source>
        <translation>ajouter un point, le supprimer, choisir sa couleur</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>Toutes les vues</translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation>Glisser avec le bouton central</translation>
    </message>
    <message>
        <source>move the picture</source>
        <translation>déplacer l&apos;image</translation>
    </message>
    <message>
        <source>Right drag, Ctrl+wheel</source>
        <translation>Glisser avec le bouton droit, Ctrl+molette</translation>
    </message>
    <message>
        <source>a menu for that place</source>
        <translation>menu pour cet endroit</translation>
    </message>
    <message>
        <source>Shift+move</source>
        <translation>Maj+déplacer</translation>
    </message>
    <message>
        <source>crosshair follows the mouse</source>
        <translation>le réticule suit la souris</translation>
    </message>
    <message>
        <source>show this view alone; Esc shows all</source>
        <translation>afficher cette vue seule&#xa0;; Échap les affiche toutes</translation>
    </message>
    <message>
        <source>Shift+wheel</source>
        <translation>Maj+molette</translation>
    </message>
    <message>
        <source>thickness of the slab, from the slice alone to 100 mm</source>
        <translation>épaisseur du bloc, de la coupe seule à 100 mm</translation>
    </message>
    <message>
        <source>The crosshair&apos;s lines, on the slices</source>
        <translation>Les lignes du réticule, sur les coupes</translation>
    </message>
    <message>
        <source>Drag a ball</source>
        <translation>Glisser une boule</translation>
    </message>
    <message>
        <source>turn the plane of that colour</source>
        <translation>tourner le plan de cette couleur</translation>
    </message>
    <message>
        <source>hold its line to rows, columns and diagonals</source>
        <translation>caler sa ligne sur lignes, colonnes et diagonales</translation>
    </message>
    <message>
        <source>turn both planes</source>
        <translation>tourner les deux plans</translation>
    </message>
    <message>
        <source>Outlines of the slices, in the 3-D views</source>
        <translation>Contours des coupes, dans les vues 3D</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Début, Fin</translation>
    </message>
    <message>
        <source>first and last slice</source>
        <translation>première et dernière coupe</translation>
    </message>
    <message>
        <source>move the picture; on the body only while clicks choose no focus (Focus menu)</source>
        <translation>déplacer l&apos;image&#xa0;; sur le corps seulement si les clics ne choisissent pas de cible (menu Cible)</translation>
    </message>
    <message>
        <source>What an archive holds</source>
        <translation>Ce que contient une archive</translation>
    </message>
    <message>
        <source>Double-click, Return</source>
        <translation>Double clic, Entrée</translation>
    </message>
    <message>
        <source>retrieve the study or series, and open it once it is whole</source>
        <translation>récupérer l&apos;examen ou la série, et l&apos;ouvrir dès qu&apos;elle est complète</translation>
    </message>
    <message>
        <source>Drag onto a view</source>
        <translation>Glisser sur une vue</translation>
    </message>
    <message>
        <source>retrieve what is selected, and open it once it is whole</source>
        <translation>récupérer la sélection, et l&apos;ouvrir dès qu&apos;elle est complète</translation>
    </message>
    <message>
        <source>DICOM tags and label table</source>
        <translation>Attributs DICOM et tableau des étiquettes</translation>
    </message>
    <message>
        <source>Click on a label</source>
        <translation>Clic sur une étiquette</translation>
    </message>
    <message>
        <source>crosshair into it</source>
        <translation>réticule à l&apos;intérieur</translation>
    </message>
    <message>
        <source>Ctrl+C, right click</source>
        <translation>Ctrl+C, clic droit</translation>
    </message>
    <message>
        <source>copy the selected rows, or a value</source>
        <translation>copier les lignes sélectionnées ou une valeur</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Images clés</translation>
    </message>
    <message>
        <source>Click, Return</source>
        <translation>Clic, Entrée</translation>
    </message>
    <message>
        <source>go back to it</source>
        <translation>y revenir</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>rename it</source>
        <translation>la renommer</translation>
    </message>
    <message>
        <source>draw the measure or arrow whose tool is chosen, then type an arrow&apos;s text; Esc ends it</source>
        <translation>tracer la mesure ou la flèche dont l&apos;outil est choisi, puis saisir le texte de la flèche ; Échap termine</translation>
    </message>
    <message>
        <source>Click, as a text&apos;s tool is chosen</source>
        <translation>Clic, quand l&apos;outil de texte est choisi</translation>
    </message>
    <message>
        <source>place a text, and type it</source>
        <translation>placer un texte et le saisir</translation>
    </message>
    <message>
        <source>copy and delete; change the text of a mark</source>
        <translation>copier et supprimer ; changer le texte d&apos;une marque</translation>
    </message>
    <message>
        <source>The path of the curved reformat, on the slices</source>
        <translation>Trajet du reformatage courbe, sur les coupes</translation>
    </message>
    <message>
        <source>Clicks, as it is being drawn</source>
        <translation>Clics, pendant qu&apos;il est tracé</translation>
    </message>
    <message>
        <source>add points; Enter or a double click ends it, Esc drops it</source>
        <translation>ajouter des points&#xa0;; Entrée ou un double clic le termine, Échap l&apos;abandonne</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retour arrière</translation>
    </message>
    <message>
        <source>take the last point away</source>
        <translation>retirer le dernier point</translation>
    </message>
    <message>
        <source>The pictures of the curved reformat</source>
        <translation>Images du reformatage courbe</translation>
    </message>
    <message>
        <source>crosshair to that place of the path</source>
        <translation>réticule à cet endroit du trajet</translation>
    </message>
    <message>
        <source>Wheel, arrows, Page, Home and End keys</source>
        <translation>Molette, flèches, touches de page, Début et Fin</translation>
    </message>
    <message>
        <source>move along the path</source>
        <translation>parcourir le trajet</translation>
    </message>
    <message>
        <source>Drag a point</source>
        <translation>Glisser un point</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>le déplacer</translation>
    </message>
</context>
<context>
    <name>Fidelity</name>
    <message>
        <source>slices are shown up to %1 mm from their true places</source>
        <translation>les coupes sont affichées jusqu&apos;à %1 mm de leur place réelle</translation>
    </message>
    <message>
        <source>tilt is made straight: %1 slices are resampled onto %2 planes</source>
        <translation>inclinaison redressée&#xa0;: %1 coupes rééchantillonnées sur %2 plans</translation>
    </message>
    <message>
        <source>%1 slices are resampled onto %2 even planes</source>
        <translation>%1 coupes rééchantillonnées sur %2 plans réguliers</translation>
    </message>
    <message>
        <source>this plane was not scanned: it is interpolated across a gap</source>
        <translation>ce plan n&apos;a pas été acquis&#xa0;: il est interpolé au-dessus d&apos;un vide</translation>
    </message>
    <message>
        <source>%1 of %2 planes are interpolated across gaps</source>
        <translation>%1 plans sur %2 sont interpolés au-dessus de vides</translation>
    </message>
    <message>
        <source>places or sizes are assumed, because the file does not give them</source>
        <translation>des positions ou tailles sont supposées, car le fichier ne les donne pas</translation>
    </message>
    <message>
        <source>some values are outside of what the file&apos;s header allows</source>
        <translation>certaines valeurs sortent de ce que l&apos;en-tête autorise</translation>
    </message>
    <message>
        <source>values are rounded to the precision of the program&apos;s numbers</source>
        <translation>les valeurs sont arrondies à la précision des nombres du programme</translation>
    </message>
    <message>
        <source>slices are missing</source>
        <translation>des coupes manquent</translation>
    </message>
    <message>
        <source>files were left out</source>
        <translation>des fichiers ont été omis</translation>
    </message>
    <message>
        <source>slices of one place were left out</source>
        <translation>des coupes de même position ont été omises</translation>
    </message>
    <message>
        <source>slices of another size or direction are shown as the first one</source>
        <translation>les coupes d&apos;autre taille ou direction sont affichées comme la première</translation>
    </message>
    <message>
        <source>the data differ from those of the session</source>
        <translation>les données diffèrent de celles de la session</translation>
    </message>
    <message>
        <source>1 file</source>
        <translation>1 fichier</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 fichiers</translation>
    </message>
    <message>
        <source>a part of the volume is clipped, by 1 plane</source>
        <translation>une partie du volume est découpée, par 1 plan</translation>
    </message>
    <message>
        <source>a part of the volume is clipped, by %1 planes</source>
        <translation>une partie du volume est découpée, par %1 plans</translation>
    </message>
    <message>
        <source>1 structure is hidden</source>
        <translation>1 structure est masquée</translation>
    </message>
    <message>
        <source>%1 structures are hidden</source>
        <translation>%1 structures sont masquées</translation>
    </message>
    <message>
        <source>a part of the volume is carved away</source>
        <translation>une partie du volume est sculptée</translation>
    </message>
    <message>
        <source>the scanner&apos;s table is left out</source>
        <translation>la table du scanner est omise</translation>
    </message>
    <message>
        <source>parts are moved apart: distances between them do not hold</source>
        <translation>des parties sont écartées&#xa0;: les distances entre elles ne valent pas</translation>
    </message>
    <message>
        <source>a layer is rolled up: distances on it do not hold</source>
        <translation>une couche est enroulée&#xa0;: les distances sur elle ne valent pas</translation>
    </message>
    <message>
        <source>values are smoothed between voxels</source>
        <translation>les valeurs sont lissées entre les voxels</translation>
    </message>
    <message>
        <source>values are smoothed over several voxels</source>
        <translation>les valeurs sont lissées sur plusieurs voxels</translation>
    </message>
    <message>
        <source>values between voxels follow a cubic spline, which may overshoot</source>
        <translation>les valeurs entre voxels suivent une spline cubique, qui peut dépasser</translation>
    </message>
    <message>
        <source>the surface of labels is smoothed lightly</source>
        <translation>la surface des étiquettes est légèrement lissée</translation>
    </message>
    <message>
        <source>the surface of labels is smoothed strongly</source>
        <translation>la surface des étiquettes est fortement lissée</translation>
    </message>
    <message>
        <source>a draft while something moves, %1 % of the size</source>
        <translation>une ébauche pendant le mouvement, %1 % de la taille</translation>
    </message>
    <message>
        <source>the sampling error has no bound (quality: %1)</source>
        <translation>l&apos;erreur d&apos;échantillonnage n&apos;est pas bornée (qualité&#xa0;: %1)</translation>
    </message>
    <message>
        <source>the sampling error is at most %1/255</source>
        <translation>l&apos;erreur d&apos;échantillonnage est au plus %L1/255</translation>
    </message>
    <message>
        <source>not verified</source>
        <translation>non vérifiée</translation>
    </message>
    <message>
        <source>verified: %1</source>
        <translation>vérifiée&#xa0;: %1</translation>
    </message>
    <message>
        <source>not yet what was asked for</source>
        <translation>pas encore ce qui est demandé</translation>
    </message>
    <message>
        <source>faithful</source>
        <translation>fidèle</translation>
    </message>
    <message>
        <source>bounded</source>
        <translation>bornée</translation>
    </message>
    <message>
        <source>approximate</source>
        <translation>approchée</translation>
    </message>
    <message>
        <source>altered</source>
        <translation>altérée</translation>
    </message>
    <message>
        <source>a slab: only the highest value of %1 mm shows</source>
        <translation>un bloc&#xa0;: seule la plus haute valeur de %1 mm se voit</translation>
    </message>
    <message>
        <source>a slab: only the lowest value of %1 mm shows</source>
        <translation>un bloc&#xa0;: seule la plus basse valeur de %1 mm se voit</translation>
    </message>
    <message>
        <source>a slab: the mean of %1 mm shows</source>
        <translation>un bloc&#xa0;: la moyenne de %1 mm se voit</translation>
    </message>
    <message>
        <source>values between voxels are interpolated linearly</source>
        <translation>les valeurs entre voxels sont interpolées linéairement</translation>
    </message>
</context>
<context>
    <name>FramePacer</name>
    <message>
        <source>draft</source>
        <translation>ébauche</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normale</translation>
    </message>
    <message>
        <source>error ≤ %1/255</source>
        <translation>erreur ≤ %L1/255</translation>
    </message>
</context>
<context>
    <name>FunctionTarget</name>
    <message>
        <source>Focus</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Fonction de transfert</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Contexte</translation>
    </message>
    <message>
        <source>Focus: %1</source>
        <translation>Cible&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>GlSupport</name>
    <message>
        <source>Qt&apos;s offscreen platform has no OpenGL; unset QT_QPA_PLATFORM.</source>
        <translation>La plateforme offscreen de Qt n&apos;a pas OpenGL&#xa0;; supprimez QT_QPA_PLATFORM.</translation>
    </message>
    <message>
        <source>No OpenGL context can be made on this display. Install the graphics driver, or Mesa&apos;s software renderer (Debian: libgl1-mesa-dri); on a remote desktop, start Fenestra there.</source>
        <translation>Aucun contexte OpenGL ne peut être créé sur cet écran. Installez le pilote graphique ou le rendu logiciel de Mesa (Debian&#xa0;: libgl1-mesa-dri)&#xa0;; sur un bureau distant, lancez Fenestra là-bas.</translation>
    </message>
    <message>
        <source>OpenGL cannot draw on this display. On a remote desktop, use one with GLX.</source>
        <translation>OpenGL ne peut pas dessiner sur cet écran. Sur un bureau distant, utilisez-en un avec GLX.</translation>
    </message>
    <message>
        <source>%1 (LIBGL_ALWAYS_SOFTWARE=1 in the environment selects it).</source>
        <translation>%1 (LIBGL_ALWAYS_SOFTWARE=1 dans l&apos;environnement le sélectionne).</translation>
    </message>
</context>
<context>
    <name>LabelName</name>
    <message>
        <source>label %1</source>
        <translation>étiquette %1</translation>
    </message>
</context>
<context>
    <name>Measure</name>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectangle</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%L1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%L1°</translation>
    </message>
    <message>
        <source>Mean %1 %2</source>
        <translation>Moy. %L1 %2</translation>
    </message>
    <message>
        <source>SD %1</source>
        <translation>ET %L1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%L1 mm²</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%L1 cm²</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Flèche</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
</context>
<context>
    <name>MeasureMenu</name>
    <message>
        <source>Copy this measure</source>
        <translation>Copier cette mesure</translation>
    </message>
    <message>
        <source>Copy all as a table (CSV)</source>
        <translation>Tout copier en tableau (CSV)</translation>
    </message>
    <message>
        <source>Delete this measure</source>
        <translation>Supprimer cette mesure</translation>
    </message>
    <message>
        <source>Delete all measures</source>
        <translation>Supprimer toutes les mesures</translation>
    </message>
    <message>
        <source>Text of the mark</source>
        <translation>Texte de la marque</translation>
    </message>
    <message>
        <source>Pictures and sessions hold it: name no patient.</source>
        <translation>Les images et les sessions le contiennent : ne nommez aucun patient.</translation>
    </message>
    <message>
        <source>Change the text…</source>
        <translation>Changer le texte…</translation>
    </message>
</context>
<context>
    <name>MethodRows</name>
    <message>
        <source>Levels</source>
        <translation>Niveaux</translation>
    </message>
    <message>
        <source>rim</source>
        <extracomment>before the number that says how thin the line around a lens is</extracomment>
        <translation>bord</translation>
    </message>
    <message>
        <source>A</source>
        <comment>axial</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>S</source>
        <comment>sagittal</comment>
        <translation>S</translation>
    </message>
    <message>
        <source>C</source>
        <comment>coronal</comment>
        <translation>C</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Coupes</translation>
    </message>
</context>
<context>
    <name>Number</name>
    <message>
        <source>%1 ml</source>
        <translation>%L1 ml</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%L1 l</translation>
    </message>
</context>
<context>
    <name>Overlay</name>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
</context>
<context>
    <name>Panels</name>
    <message>
        <source>Focus</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Caméras</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>Clipping</source>
        <translation>Découpe</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Contexte</translation>
    </message>
    <message>
        <source>Context edges</source>
        <translation>Arêtes</translation>
    </message>
    <message>
        <source>Cutaway</source>
        <translation>Écorché</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Séries</translation>
    </message>
    <message>
        <source>DICOM tags</source>
        <translation>Attributs DICOM</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Label table</source>
        <translation>Tableau des étiquettes</translation>
    </message>
    <message>
        <source>Ctrl+Shift+T</source>
        <translation>Ctrl+Shift+T</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Images clés</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>Curved reformat</source>
        <translation>Reformatage courbe</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R</source>
        <translation>Ctrl+Shift+R</translation>
    </message>
</context>
<context>
    <name>Patient</name>
    <message>
        <source>ID %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>né(e) le %1</translation>
    </message>
</context>
<context>
    <name>PlacementForm</name>
    <message>
        <source>From the side of the body that the focus is nearer to, rather than through the body, where both show about as much</source>
        <translation>Du côté du corps dont la cible est la plus proche plutôt qu&apos;à travers le corps, si les deux montrent à peu près autant</translation>
    </message>
</context>
<context>
    <name>PlaneMenu</name>
    <message>
        <source>Slab of the %1 slice</source>
        <translation>Bloc de la coupe&#xa0;: %1</translation>
    </message>
    <message>
        <source>Thickness in mm, half of it to each side; 0 is the slice alone:</source>
        <translation>Épaisseur en mm, la moitié de chaque côté&#xa0;; 0 est la coupe seule&#xa0;:</translation>
    </message>
    <message>
        <source>Off: the slice alone</source>
        <translation>Sans&#xa0;: la coupe seule</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%L1 mm</translation>
    </message>
    <message>
        <source>Other: %1 mm…</source>
        <translation>Autre&#xa0;: %1 mm…</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Autre…</translation>
    </message>
    <message>
        <source>Maximum (MIP)</source>
        <translation>Maximum (MIP)</translation>
    </message>
    <message>
        <source>Minimum (MinIP)</source>
        <translation>Minimum (MinIP)</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>All slices as this one</source>
        <translation>Toutes les coupes comme celle-ci</translation>
    </message>
    <message>
        <source>Slice faces C1</source>
        <translation>Coupe face à C1</translation>
    </message>
    <message>
        <source>Slice faces C2</source>
        <translation>Coupe face à C2</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Bloc</translation>
    </message>
    <message>
        <source>Reset this slice&apos;s plane</source>
        <translation>Réinitialiser le plan de cette coupe</translation>
    </message>
    <message>
        <source>Reset all planes</source>
        <translation>Réinitialiser tous les plans</translation>
    </message>
</context>
<context>
    <name>PlaneTool</name>
    <message>
        <source>%1°</source>
        <translation>%L1°</translation>
    </message>
</context>
<context>
    <name>Reader</name>
    <message>
        <source>the scanner&apos;s table is left out of 3-D pictures; slices show it</source>
        <translation>la table du scanner est omise des images 3-D ; les coupes la montrent</translation>
    </message>
    <message>
        <source>the file names no modality; its values (%1 to %2) are taken for Hounsfield units of a CT</source>
        <translation>le fichier n&apos;indique pas de modalité ; ses valeurs (%1 à %2) sont prises pour des unités Hounsfield d&apos;un scanner CT</translation>
    </message>
    <message>
        <source>the file stores no orientation; its axes are taken as right, anterior, superior</source>
        <translation>le fichier ne contient pas d&apos;orientation ; ses axes sont pris pour droite, avant, haut</translation>
    </message>
    <message>
        <source>the file does not say where the slice lies in the patient</source>
        <translation>le fichier ne dit pas où la coupe se trouve dans le patient</translation>
    </message>
    <message>
        <source>the file does not say where its slices lie in the patient; their Slice Location gives their order and a distance of %1 mm, the place is a guess</source>
        <translation>le fichier ne dit pas où ses coupes se trouvent dans le patient ; leur Slice Location donne l&apos;ordre et une distance de %1 mm, le lieu est supposé</translation>
    </message>
    <message>
        <source>the file does not say where its slices lie in the patient; they are shown in their stored order, at a distance that is a guess (%1 mm, %2)</source>
        <translation>le fichier ne dit pas où ses coupes se trouvent dans le patient ; elles sont montrées dans l&apos;ordre enregistré, à une distance supposée (%1 mm, %2)</translation>
    </message>
    <message>
        <source>no pixel spacing is given; 1 mm is assumed</source>
        <translation>aucun espacement des pixels n&apos;est donné ; 1 mm est supposé</translation>
    </message>
    <message>
        <source>the pixel spacing is the detector&apos;s; distances in the patient are smaller</source>
        <translation>l&apos;espacement des pixels est celui du détecteur ; les distances dans le patient sont plus petites</translation>
    </message>
    <message>
        <source>its header has no ElementSpacing; 1 mm is assumed</source>
        <translation>son en-tête n&apos;a pas d&apos;ElementSpacing ; 1 mm est supposé</translation>
    </message>
    <message>
        <source>its header has no spacings; 1 mm is assumed</source>
        <translation>son en-tête n&apos;a pas d&apos;espacements ; 1 mm est supposé</translation>
    </message>
    <message>
        <source>the file holds %1 volumes (time points or layers); number %2 is shown</source>
        <translation>le fichier contient %1 volumes (instants ou couches) ; le numéro %2 est montré</translation>
    </message>
    <message>
        <source>all %1 frames lie at one position (time points or repeats, no deeper volume%2); each forms a volume of its own: number %3 is shown</source>
        <translation>les %1 images sont à une même position (instants ou répétitions, pas de volume plus profond%2) ; chacune forme un volume à elle seule : le numéro %3 est montré</translation>
    </message>
    <message>
        <source>%1 frames lie at each position (time points or repeats, no deeper volume%2); each forms a volume of its own: number %3 is shown</source>
        <translation>il y a %1 images à chaque position (instants ou répétitions, pas de volume plus profond%2) ; chacune forme un volume à elle seule : le numéro %3 est montré</translation>
    </message>
    <message>
        <source>; told apart by %1</source>
        <translation>; distinguées par %1</translation>
    </message>
    <message>
        <source>the slices are tilted by %1 degrees against the direction they are stacked in (%2 mm sideways from slice to slice)</source>
        <translation>les coupes sont inclinées de %1 degrés par rapport à la direction d&apos;empilement (%2 mm de côté d&apos;une coupe à l&apos;autre)</translation>
    </message>
    <message>
        <source>%1 missing: neighbours lie %2 mm apart, but up to %3 mm between the files named</source>
        <translation>il manque %1 : les voisines sont à %2 mm, mais jusqu&apos;à %3 mm entre les fichiers nommés</translation>
    </message>
    <message>
        <source>the slices lie between %1 mm and %2 mm apart</source>
        <translation>les coupes sont espacées de %1 mm à %2 mm</translation>
    </message>
    <message>
        <source>%1 shifted sideways by up to %2 mm from the line that the first and the last one lie on</source>
        <translation>%1 décalées de côté jusqu&apos;à %2 mm de la ligne qui passe par la première et la dernière</translation>
    </message>
    <message>
        <source>%1 with other directions or pixel spacing than the first; shown with those of the first, pixels lie up to %2 mm from their places</source>
        <translation>%1 d&apos;autres directions ou d&apos;un autre espacement que la première ; montrées comme la première, des pixels sont jusqu&apos;à %2 mm de leur lieu</translation>
    </message>
    <message>
        <source>the volume is sheared, so that every slice lies where it was scanned</source>
        <translation>le volume est cisaillé, de sorte que chaque coupe est là où elle a été acquise</translation>
    </message>
    <message>
        <source>all slices are shown %1 mm apart, up to %2 mm from where they were scanned</source>
        <translation>toutes les coupes sont montrées à %1 mm, jusqu&apos;à %2 mm de là où elles ont été acquises</translation>
    </message>
    <message>
        <source>%1; %2 of the voxels lie outside of what was scanned and hold the least value, %3</source>
        <translation>%1 ; %2 des voxels sont hors de ce qui a été acquis et ont la plus petite valeur, %3</translation>
    </message>
    <message>
        <source>%1; %2 in gaps wider than %3 mm is interpolated across the gap</source>
        <translation>%1 ; %2 dans un vide de plus de %3 mm est interpolé à travers le vide</translation>
    </message>
    <message>
        <source>%1; %2 in gaps wider than %3 mm are interpolated across the gap</source>
        <translation>%1 ; %2 dans des vides de plus de %3 mm sont interpolés à travers le vide</translation>
    </message>
    <message>
        <source>%1 (evenly spread they would lie up to %2 mm from their places)</source>
        <translation>%1 (réparties également, elles seraient jusqu&apos;à %2 mm de leur lieu)</translation>
    </message>
    <message>
        <source>%1, with nothing displaced</source>
        <translation>%1, sans rien déplacer</translation>
    </message>
    <message>
        <source>%1, displaced by up to %2 mm</source>
        <translation>%1, déplacées de %2 mm au plus</translation>
    </message>
    <message>
        <source>%1, sheared as they were scanned</source>
        <translation>%1, cisaillés comme à l&apos;acquisition</translation>
    </message>
    <message>
        <source>linear interpolation places the slices on %1 planes %2 mm apart</source>
        <translation>l&apos;interpolation linéaire place les coupes sur %1 plans à %2 mm</translation>
    </message>
    <message>
        <source>cubic interpolation places the slices on %1 planes %2 mm apart</source>
        <translation>l&apos;interpolation cubique place les coupes sur %1 plans à %2 mm</translation>
    </message>
    <message>
        <source>%1 left out: the same images (SOP instances) as in other files</source>
        <translation>%1 laissés de côté : les mêmes images (instances SOP) que dans d&apos;autres fichiers</translation>
    </message>
    <message>
        <source>%1 of the folder left out: not DICOM</source>
        <translation>%1 du dossier laissés de côté : pas du DICOM</translation>
    </message>
    <message>
        <source>%1 left out, unreadable (the first: %2)</source>
        <translation>%1 laissés de côté, illisibles (le premier : %2)</translation>
    </message>
    <message>
        <source>%1 listed in the DICOMDIR missing</source>
        <translation>%1 du DICOMDIR manquent</translation>
    </message>
    <message>
        <source>%1 left out, at positions that other slices have already</source>
        <translation>%1 laissées de côté, à des positions que d&apos;autres coupes ont déjà</translation>
    </message>
    <message>
        <source>%1 of the series put into volumes of their own: %2</source>
        <translation>%1 de la série mises dans des volumes à part : %2</translation>
    </message>
    <message>
        <source>another size or pixel spacing</source>
        <translation>autre taille ou autre espacement des pixels</translation>
    </message>
    <message>
        <source>another orientation</source>
        <translation>autre orientation</translation>
    </message>
    <message>
        <source>another frame of reference, frame type or stack</source>
        <translation>autre repère, type d&apos;image ou pile</translation>
    </message>
    <message>
        <source>%1 slices have a Series UID each; they agree in study and kind and lie evenly, and are taken for one series</source>
        <translation>%1 coupes ont chacune un UID de série ; elles s&apos;accordent par l&apos;examen et le type et sont régulières, et sont prises pour une série</translation>
    </message>
    <message>
        <source>%1 left out: %2</source>
        <translation>%1 laissés de côté : %2</translation>
    </message>
    <message>
        <source>the focus has no voxels in this volume</source>
        <translation>la cible n&apos;a pas de voxels dans ce volume</translation>
    </message>
    <message>
        <source>the volume %1 is not what it was when the session was saved</source>
        <translation>le volume %1 n&apos;est plus ce qu&apos;il était quand la session a été enregistrée</translation>
    </message>
    <message>
        <source>the label map %1 is not what it was when the session was saved</source>
        <translation>la carte d&apos;étiquettes %1 n&apos;est plus ce qu&apos;elle était quand la session a été enregistrée</translation>
    </message>
    <message>
        <source>the volume was found at %1, no longer at %2</source>
        <translation>le volume a été trouvé dans %1, non plus dans %2</translation>
    </message>
    <message>
        <source>the label map was found at %1, no longer at %2</source>
        <translation>la carte d&apos;étiquettes a été trouvée dans %1, non plus dans %2</translation>
    </message>
    <message>
        <source>%1 (in %2 of %3 slices)</source>
        <translation>%1 (dans %2 coupes sur %3)</translation>
    </message>
    <message>
        <source>%1 file</source>
        <translation>%1 fichier</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 fichiers</translation>
    </message>
    <message>
        <source>%1 slice</source>
        <translation>%1 coupe</translation>
    </message>
    <message>
        <source>%1 slices</source>
        <translation>%1 coupes</translation>
    </message>
    <message>
        <source>%1 plane</source>
        <translation>%1 plan</translation>
    </message>
    <message>
        <source>%1 planes</source>
        <translation>%1 plans</translation>
    </message>
</context>
<context>
    <name>Region</name>
    <message>
        <source>Its border is clear: values change by %1 there.</source>
        <translation>Sa limite est nette&#xa0;: les valeurs y changent de %1.</translation>
    </message>
    <message>
        <source>Its border is fair: values change by %1 there.</source>
        <translation>Sa limite est moyenne&#xa0;: les valeurs y changent de %1.</translation>
    </message>
    <message>
        <source>It is doubtful: nearly any other tolerance makes it far larger or smaller. Check its outline on the slices.</source>
        <translation>Elle est douteuse&#xa0;: presque toute autre tolérance la rend bien plus grande ou plus petite. Vérifiez son contour sur les coupes.</translation>
    </message>
    <message>
        <source>It is doubtful: another region here, far larger or smaller, is nearly as clear. Check its outline on the slices.</source>
        <translation>Elle est douteuse&#xa0;: une autre région à cet endroit, bien plus grande ou plus petite, est presque aussi nette. Vérifiez son contour sur les coupes.</translation>
    </message>
    <message>
        <source>It is doubtful: it spreads from a thin part at the click into a thicker one. Check its outline on the slices.</source>
        <translation>Elle est douteuse&#xa0;: elle s&apos;étend d&apos;une partie mince, à l&apos;endroit du clic, à une plus épaisse. Vérifiez son contour sur les coupes.</translation>
    </message>
    <message>
        <source>It is doubtful: it is a flat tube, as two vessels side by side are. Check its outline on the slices.</source>
        <translation>Elle est douteuse&#xa0;: c&apos;est un tube aplati, comme deux vaisseaux côte à côte. Vérifiez son contour sur les coupes.</translation>
    </message>
    <message>
        <source>It is doubtful: values change by only %1 along its border. Check its outline on the slices.</source>
        <translation>Elle est douteuse&#xa0;: à sa limite, les valeurs ne changent que de %1. Vérifiez son contour sur les coupes.</translation>
    </message>
    <message>
        <source>the left</source>
        <translation>la gauche</translation>
    </message>
    <message>
        <source>the right</source>
        <translation>la droite</translation>
    </message>
    <message>
        <source>the back</source>
        <translation>l&apos;arrière</translation>
    </message>
    <message>
        <source>the front</source>
        <translation>l&apos;avant</translation>
    </message>
    <message>
        <source>the head</source>
        <translation>la tête</translation>
    </message>
    <message>
        <source>the feet</source>
        <translation>les pieds</translation>
    </message>
    <message>
        <source>on all sides</source>
        <translation>de tous côtés</translation>
    </message>
    <message>
        <source>towards %1</source>
        <translation>vers %1</translation>
    </message>
    <message>
        <source>towards %1 and %2</source>
        <translation>vers %1 et %2</translation>
    </message>
    <message>
        <source>Values: %1 ± %2.</source>
        <translation>Valeurs&#xa0;: %1 ± %2.</translation>
    </message>
    <message>
        <source>Next leak: at %1 to %2, %3.</source>
        <translation>Prochaine fuite&#xa0;: à %1 vers %2, %3.</translation>
    </message>
</context>
<context>
    <name>RegionBall</name>
    <message>
        <source>%1 mm</source>
        <translation>%L1 mm</translation>
    </message>
</context>
<context>
    <name>RenderProblem</name>
    <message>
        <source>The graphics driver refuses a part of Fenestra (%1). Update the driver, or start Fenestra with LIBGL_ALWAYS_SOFTWARE=1 in the environment.</source>
        <translation>Le pilote graphique refuse une partie de Fenestra (%1). Mettez-le à jour, ou lancez Fenestra avec LIBGL_ALWAYS_SOFTWARE=1 dans l&apos;environnement.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture. Close other programs, or open a smaller volume.</source>
        <translation>Pas assez de mémoire pour cette image. Fermez d&apos;autres programmes, ou ouvrez un volume plus petit.</translation>
    </message>
</context>
<context>
    <name>Results</name>
    <message>
        <source>Focus</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Étiquettes</translation>
    </message>
    <message>
        <source>Segments of the measures</source>
        <translation>Segments des mesures</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Images clés</translation>
    </message>
</context>
<context>
    <name>Series</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>every %1</source>
        <translation>tous les %1</translation>
    </message>
    <message>
        <source>%1, every %2</source>
        <translation>%1, tous les %2</translation>
    </message>
    <message>
        <source>time point %1 of %2</source>
        <translation>instant %1 sur %2</translation>
    </message>
    <message>
        <source>Series without a name</source>
        <translation>Série sans nom</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Série %1</translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation>Examen %1</translation>
    </message>
</context>
<context>
    <name>ServerEntry</name>
    <message>
        <source>The server&apos;s AE title has 1 to 16 letters and digits; its administrator knows it.</source>
        <translation>Le titre AE du serveur a de 1 à 16 lettres et chiffres&#xa0;; son administrateur le connaît.</translation>
    </message>
    <message>
        <source>Our AE title has 1 to 16 letters and digits; the server must know it.</source>
        <translation>Notre titre AE a de 1 à 16 lettres et chiffres&#xa0;; le serveur doit le connaître.</translation>
    </message>
    <message>
        <source>The host is a name or an address, such as pacs.hospital or 192.168.1.5.</source>
        <translation>L&apos;hôte est un nom ou une adresse, comme pacs.hospital ou 192.168.1.5.</translation>
    </message>
    <message>
        <source>C-MOVE needs a port of ours that is entered at the server.</source>
        <translation>C-MOVE a besoin d&apos;un port à nous, enregistré sur le serveur.</translation>
    </message>
    <message>
        <source>TLS needs the file of the certificates that may sign the server&apos;s, in PEM.</source>
        <translation>TLS a besoin du fichier PEM des certificats qui peuvent signer celui du serveur.</translation>
    </message>
    <message>
        <source>Our certificate needs its key, and the key its certificate.</source>
        <translation>Notre certificat a besoin de sa clé, et la clé de son certificat.</translation>
    </message>
    <message>
        <source>The address is that of DICOMweb&apos;s root, such as https://pacs.hospital/dicom-web.</source>
        <translation>L&apos;adresse est celle de la racine de DICOMweb, comme https://pacs.hospital/dicom-web.</translation>
    </message>
    <message>
        <source>A login with a password needs the user&apos;s name.</source>
        <translation>Une connexion par mot de passe a besoin du nom de l&apos;utilisateur.</translation>
    </message>
    <message>
        <source>This desktop has no key ring that runs, so the password or token is not kept.</source>
        <translation>Aucun trousseau ne fonctionne sur ce bureau : le mot de passe ou le jeton n&apos;est pas conservé.</translation>
    </message>
    <message>
        <source>The key ring was not opened, so the password or token is neither read nor kept.</source>
        <translation>Le trousseau n&apos;a pas été ouvert : le mot de passe ou le jeton n&apos;est ni lu ni conservé.</translation>
    </message>
    <message>
        <source>The key ring cannot be used: %1</source>
        <translation>Le trousseau ne peut pas être utilisé : %1</translation>
    </message>
    <message>
        <source>Waiting for the key ring of the desktop…</source>
        <translation>Attente du trousseau du bureau…</translation>
    </message>
    <message>
        <source>Go on without</source>
        <translation>Continuer sans lui</translation>
    </message>
    <message>
        <source>The key ring was not waited for.</source>
        <translation>Le trousseau n&apos;a pas été attendu.</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>Light theme</source>
        <translation>Thème clair</translation>
    </message>
    <message>
        <source>Light colours around the pictures, for bright rooms</source>
        <translation>Couleurs claires autour des images, pour les pièces lumineuses</translation>
    </message>
    <message>
        <source>Animate the cameras</source>
        <translation>Animer les caméras</translation>
    </message>
    <message>
        <source>Cameras fly to where they are placed instead of jumping there</source>
        <translation>Les caméras volent à leur place au lieu d&apos;y sauter</translation>
    </message>
    <message>
        <source>While something moves</source>
        <translation>Pendant un mouvement</translation>
    </message>
    <message>
        <source>Pictures a second to aim at: more of them are smaller on a slow machine. At rest they always have full quality</source>
        <translation>Images par seconde visées&#xa0;: davantage sont plus petites sur une machine lente. Au repos, elles ont toujours la pleine qualité</translation>
    </message>
    <message>
        <source>pictures/s</source>
        <translation>images/s</translation>
    </message>
    <message>
        <source>Background of new data</source>
        <translation>Fond des nouvelles données</translation>
    </message>
    <message>
        <source>Colour behind the volume when data are opened without a session</source>
        <translation>Couleur derrière le volume quand des données s&apos;ouvrent sans session</translation>
    </message>
    <message>
        <source>Unit of new openings</source>
        <translation>Unité des nouvelles ouvertures</translation>
    </message>
    <message>
        <source>What the widths of the opening are in when data are opened without a session</source>
        <translation>Unité des largeurs de l&apos;ouverture quand des données s&apos;ouvrent sans session</translation>
    </message>
    <message>
        <source>Hide the patient</source>
        <translation>Masquer le patient</translation>
    </message>
    <message>
        <source>No patient and no study in corner texts, and no folder that may be named after them in the recent list and in what file dialogs remember</source>
        <translation>Ni patient ni examen dans les textes des coins, ni dossier pouvant porter leur nom dans la liste des récents et la mémoire des dialogues de fichiers</translation>
    </message>
    <message>
        <source>Remember recent data</source>
        <translation>Retenir les données récentes</translation>
    </message>
    <message>
        <source>List the folders and files opened last in the File menu</source>
        <translation>Liste dans le menu Fichier les derniers dossiers et fichiers ouverts</translation>
    </message>
    <message>
        <source>Keep a copy of unsaved work</source>
        <translation>Garder une copie du travail non enregistré</translation>
    </message>
    <message>
        <source>Every minute, to be offered after a crash</source>
        <translation>Chaque minute, proposée après un plantage</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>How the view is opened to the focus</source>
        <translation>Comment la vue s&apos;ouvre vers la cible</translation>
    </message>
    <message>
        <source>Adaptive cutaway</source>
        <translation>Écorché adaptatif</translation>
    </message>
    <message>
        <source>An opening around the focus that rises to the surface over a width that you choose: the method of this program</source>
        <translation>Une ouverture autour de la cible, qui remonte à la surface sur une largeur que vous choisissez&#xa0;: la méthode de ce programme</translation>
    </message>
    <message>
        <source>Deformable cutting plane</source>
        <translation>Plan de coupe déformable</translation>
    </message>
    <message>
        <source>Nothing opens by itself: a plane that you lay through a stroke and bend by dragging removes one side of it (Konrad-Verse, Preim and Littmann 2004)</source>
        <translation>Rien ne s&apos;ouvre tout seul&#xa0;: un plan posé par un trait et courbé en glissant enlève l&apos;un de ses côtés (Konrad-Verse, Preim et Littmann 2004)</translation>
    </message>
    <message>
        <source>ClearView</source>
        <translation>ClearView</translation>
    </message>
    <message>
        <source>A lens over the focus through which it shows, while what hides it fades towards the lens&apos;s middle and stays where it bends (Krüger, Schneider and Westermann 2006)</source>
        <translation>Une lentille sur la cible, à travers laquelle elle se voit, tandis que ce qui la cache s&apos;estompe vers le milieu et reste là où il se courbe (Krüger, Schneider et Westermann 2006)</translation>
    </message>
    <message>
        <source>Lens keeps</source>
        <translation>La lentille garde</translation>
    </message>
    <message>
        <source>What stays within ClearView&apos;s lens of what hides the focus, beside its bends</source>
        <translation>Ce qui reste dans la lentille de ClearView de ce qui cache la cible, outre ses courbures</translation>
    </message>
    <message>
        <source>Lens over</source>
        <translation>Lentille sur</translation>
    </message>
    <message>
        <source>What ClearView&apos;s lens lies over, as you see it</source>
        <translation>Ce sur quoi la lentille de ClearView se trouve, vu de vous</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Lentille</translation>
    </message>
    <message>
        <source>Radius of ClearView&apos;s lens, as a share of the volume&apos;s longest side; its authors use 18.2</source>
        <translation>Rayon de la lentille de ClearView, en part du plus long côté du volume&#xa0;; ses auteurs prennent 18,2</translation>
    </message>
    <message>
        <source>Bends kept</source>
        <translation>Courbures gardées</translation>
    </message>
    <message>
        <source>How much of the bends of what hides the focus stays within ClearView&apos;s lens; 0 keeps none</source>
        <translation>Part des courbures de ce qui cache la cible gardée dans la lentille de ClearView&#xa0;; 0 n&apos;en garde aucune</translation>
    </message>
    <message>
        <source>Rim of the lens</source>
        <translation>Bord de la lentille</translation>
    </message>
    <message>
        <source>How thin the dark line around ClearView&apos;s lens is: more is thinner</source>
        <translation>Finesse de la ligne sombre autour de la lentille de ClearView&#xa0;: plus est plus fin</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>The middle of the focus</source>
        <translation>Le milieu de la cible</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>Réticule</translation>
    </message>
    <message>
        <source>The crosshair: the lens follows what you point at</source>
        <translation>Le réticule&#xa0;: la lentille suit ce que vous pointez</translation>
    </message>
    <message>
        <source>To the rim</source>
        <translation>Vers le bord</translation>
    </message>
    <message>
        <source>The nearer to the lens&apos;s rim, the more of what hides the focus</source>
        <translation>Plus on est près du bord de la lentille, plus il reste de ce qui cache la cible</translation>
    </message>
    <message>
        <source>Evenly</source>
        <translation>Uniformément</translation>
    </message>
    <message>
        <source>Nothing but the bends of what hides the focus</source>
        <translation>Rien que les courbures de ce qui cache la cible</translation>
    </message>
    <message>
        <source>With depth</source>
        <translation>Avec la profondeur</translation>
    </message>
    <message>
        <source>The more lies in front of the focus, the more of it</source>
        <translation>Plus il y a devant la cible, plus il en reste</translation>
    </message>
    <message>
        <source>Cone cutaway</source>
        <translation>Écorché conique</translation>
    </message>
    <message>
        <source>A funnel around everything in focus, which widens towards you at one angle: the deeper the focus lies, the wider the opening (Burns and Finkelstein 2008)</source>
        <translation>Un entonnoir autour de toute la cible, qui s&apos;évase vers vous d&apos;un angle&#xa0;: plus la cible est profonde, plus l&apos;ouverture est large (Burns et Finkelstein 2008)</translation>
    </message>
    <message>
        <source>Cone&apos;s angle</source>
        <translation>Angle du cône</translation>
    </message>
    <message>
        <source>Angle between the axis and the wall of the cone cutaway&apos;s cones: more opens wider</source>
        <translation>Angle entre l&apos;axe et la paroi des cônes&#xa0;: plus ouvre davantage</translation>
    </message>
    <message>
        <source>Context-preserving</source>
        <translation>Préserve le contexte</translation>
    </message>
    <message>
        <source>Nothing is cut away: what is flat, brightly lit and near to you fades, while edges stay, so that the inside shows; what is in focus stays as it is (Bruckner, Grimm, Kanitsar and Gröller 2006)</source>
        <translation>Rien n&apos;est enlevé&#xa0;: ce qui est plat, vivement éclairé et proche s&apos;estompe, les arêtes restent, et l&apos;intérieur se voit&#xa0;; la cible reste telle quelle (Bruckner, Grimm, Kanitsar et Gröller 2006)</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Portée</translation>
    </message>
    <message>
        <source>How deep the context-preserving method looks into the volume; 0 fades nothing (κt)</source>
        <translation>Profondeur à laquelle la méthode qui préserve le contexte regarde dans le volume&#xa0;; 0 n&apos;estompe rien (κt)</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Netteté</translation>
    </message>
    <message>
        <source>How sudden the context-preserving method changes from faded to shown along the line of sight: more looks like a cut (κs)</source>
        <translation>Soudaineté du passage d&apos;estompé à affiché le long de la ligne de visée&#xa0;: plus ressemble à une coupe (κs)</translation>
    </message>
    <message>
        <source>Exploded view</source>
        <translation>Vue éclatée</translation>
    </message>
    <message>
        <source>What is around the focus is cut into parts, which move apart and out of your line of sight to it; what is in focus stays in its place (Bruckner and Gröller 2006)</source>
        <translation>Ce qui entoure la cible est coupé en parties qui s&apos;écartent hors de la ligne de visée&#xa0;; la cible reste en place (Bruckner et Gröller 2006)</translation>
    </message>
    <message>
        <source>Explosion</source>
        <translation>Éclatement</translation>
    </message>
    <message>
        <source>How far the parts of an exploded view are moved apart (its degree of explosion): at 0 all are in their places</source>
        <translation>Écartement des parties (degré d&apos;éclatement)&#xa0;: à 0, toutes sont à leur place</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Parties</translation>
    </message>
    <message>
        <source>How many planes through the middle of the focus, or of the volume without a focus, cut it into the parts of an exploded view</source>
        <translation>Nombre de plans par le milieu de la cible, ou du volume sans cible, qui le coupent en parties d&apos;une vue éclatée</translation>
    </message>
    <message>
        <source>Cut along</source>
        <translation>Couper selon</translation>
    </message>
    <message>
        <source>Whether the planes of an exploded view lie along the patient&apos;s axes or the view&apos;s</source>
        <translation>Si les plans suivent les axes du patient ou ceux de la vue</translation>
    </message>
    <message>
        <source>Two halves</source>
        <translation>Deux moitiés</translation>
    </message>
    <message>
        <source>One plane cuts the volume into left and right</source>
        <translation>Un plan coupe le volume en gauche et droite</translation>
    </message>
    <message>
        <source>Four quarters</source>
        <translation>Quatre quarts</translation>
    </message>
    <message>
        <source>Two planes: left and right, above and below</source>
        <translation>Deux plans&#xa0;: gauche et droite, haut et bas</translation>
    </message>
    <message>
        <source>Eight parts</source>
        <translation>Huit parties</translation>
    </message>
    <message>
        <source>Three planes: left and right, above and below, front and back</source>
        <translation>Trois plans&#xa0;: gauche et droite, haut et bas, avant et arrière</translation>
    </message>
    <message>
        <source>The patient</source>
        <translation>Le patient</translation>
    </message>
    <message>
        <source>Planes along the patient&apos;s axes: left and right are the patient&apos;s</source>
        <translation>Plans selon les axes du patient&#xa0;: gauche et droite sont celles du patient</translation>
    </message>
    <message>
        <source>The view</source>
        <translation>La vue</translation>
    </message>
    <message>
        <source>Planes along the picture&apos;s axes, which turn with the camera</source>
        <translation>Plans selon les axes de l&apos;image, qui tournent avec la caméra</translation>
    </message>
    <message>
        <source>Focal region</source>
        <translation>Région focale</translation>
    </message>
    <message>
        <source>A region around the focus shows as it is; around it only the edges of what is there stay, the fainter the farther away; what is in focus stays as it is (Zhou, Hinz and Tönnies 2002)</source>
        <translation>Une région autour de la cible se voit telle quelle&#xa0;; autour, seules les arêtes restent, d&apos;autant plus faibles qu&apos;elles sont loin&#xa0;; la cible reste telle quelle (Zhou, Hinz et Tönnies 2002)</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Région</translation>
    </message>
    <message>
        <source>Shape of the focal region, around the focus, or around the middle of the volume without a focus</source>
        <translation>Forme de la région focale, autour de la cible, ou du milieu du volume sans cible</translation>
    </message>
    <message>
        <source>Size of region</source>
        <translation>Taille de la région</translation>
    </message>
    <message>
        <source>Radius of the focal region&apos;s sphere, half the side of its box, or its distance from the focus</source>
        <translation>Rayon de la sphère, demi-côté de la boîte, ou distance à la cible</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Fall-off</source>
        <translation>Décroissance</translation>
    </message>
    <message>
        <source>How far outside of the focal region edges are half as strong as at its border: more shows more of what is around it</source>
        <translation>À quelle distance de la région focale les arêtes sont moitié moins fortes qu&apos;à son bord&#xa0;: plus montre plus des alentours</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Sphère</translation>
    </message>
    <message>
        <source>A ball around the middle of the focus</source>
        <translation>Une boule autour du milieu de la cible</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boîte</translation>
    </message>
    <message>
        <source>A cube along the patient&apos;s axes, around the middle of the focus</source>
        <translation>Un cube selon les axes du patient, autour du milieu de la cible</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Everything that lies near the focus, whatever its shape</source>
        <translation>Tout ce qui est proche de la cible, quelle que soit sa forme</translation>
    </message>
    <message>
        <source>Importance-driven</source>
        <translation>Selon l&apos;importance</translation>
    </message>
    <message>
        <source>What hides the focus gives way to it because the focus is more important: it is removed, or stays faint (Viola, Kanitsar and Gröller 2004)</source>
        <translation>Ce qui cache la cible s&apos;efface, car elle est plus importante&#xa0;: enlevé, ou estompé (Viola, Kanitsar et Gröller 2004)</translation>
    </message>
    <message>
        <source>What hides the focus</source>
        <translation>Ce qui cache la cible</translation>
    </message>
    <message>
        <source>What the importance-driven method does with what hides the focus</source>
        <translation>Ce que la méthode selon l&apos;importance fait de ce qui cache la cible</translation>
    </message>
    <message>
        <source>Widening</source>
        <translation>Évasement</translation>
    </message>
    <message>
        <source>Angle at which the importance-driven opening widens from the focus&apos;s outline towards the eye</source>
        <translation>Angle d&apos;évasement de l&apos;ouverture, du contour de la cible vers l&apos;œil</translation>
    </message>
    <message>
        <source>Opacity left</source>
        <translation>Opacité restante</translation>
    </message>
    <message>
        <source>Factor of the opacity of what hides the focus, where the importance-driven method keeps it faint; 0 removes it</source>
        <translation>Facteur d&apos;opacité de ce qui cache la cible, là où la méthode l&apos;estompe&#xa0;; 0 l&apos;enlève</translation>
    </message>
    <message>
        <source>Faint how</source>
        <translation>Comment estompé</translation>
    </message>
    <message>
        <source>How what hides the focus is made faint</source>
        <translation>Comment ce qui cache la cible est estompé</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Enlevé</translation>
    </message>
    <message>
        <source>What hides the focus is removed, in a cone that widens from the focus&apos;s outline towards you (maximum importance projection)</source>
        <translation>Ce qui cache la cible est enlevé, dans un cône qui s&apos;évase de son contour vers vous (maximum importance projection)</translation>
    </message>
    <message>
        <source>Faint</source>
        <translation>Estompé</translation>
    </message>
    <message>
        <source>What hides the focus stays, but faint (average importance compositing)</source>
        <translation>Ce qui cache la cible reste, mais estompé (average importance compositing)</translation>
    </message>
    <message>
        <source>See-through</source>
        <translation>Translucide</translation>
    </message>
    <message>
        <source>Less opaque, in its own colours</source>
        <translation>Moins opaque, dans ses propres couleurs</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Gris</translation>
    </message>
    <message>
        <source>Less opaque, and grey, so that the colours are the focus&apos;s alone</source>
        <translation>Moins opaque et gris, pour que seule la cible ait des couleurs</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>Pointillé</translation>
    </message>
    <message>
        <source>As it is on a few pixels in an even pattern, and left out on the others</source>
        <translation>Tel quel sur quelques pixels en motif régulier, et omis sur les autres</translation>
    </message>
    <message>
        <source>Maximum intensity (MIP)</source>
        <translation>Intensité maximale (MIP)</translation>
    </message>
    <message>
        <source>The body shows by the greatest value on each line of sight, as in a maximum intensity projection, and the focus stands in it; what lies before the opening does not count (Wallis, Miller, Lerner and Kleerup 1989)</source>
        <translation>Le corps se voit par la plus grande valeur de chaque ligne de visée, comme en projection d&apos;intensité maximale, avec la cible dedans&#xa0;; ce qui est devant l&apos;ouverture ne compte pas (Wallis, Miller, Lerner et Kleerup 1989)</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>How thick a layer the maximum intensity projection shows of the greatest value: more is more opaque</source>
        <translation>Épaisseur de la couche de plus grande valeur que montre la projection d&apos;intensité maximale&#xa0;: plus est plus opaque</translation>
    </message>
    <message>
        <source>Peeling</source>
        <translation>Épluchage</translation>
    </message>
    <message>
        <source>A layer in front of the focus is cut in two, and its halves are rolled aside like a peel; what is in focus stays in its place (McGuffin et al. 2003; Correa et al. 2006)</source>
        <translation>Une couche devant la cible est coupée en deux, et ses moitiés sont enroulées sur les côtés comme une peau&#xa0;; la cible reste en place (McGuffin et al. 2003&#xa0;; Correa et al. 2006)</translation>
    </message>
    <message>
        <source>Peeled</source>
        <translation>Épluché</translation>
    </message>
    <message>
        <source>How far the layer in front of the focus is peeled away: at 0 it lies in its place, at 1 none of it lies in front of the focus</source>
        <translation>Degré d&apos;épluchage de la couche devant la cible&#xa0;: à 0 elle est en place, à 1 rien n&apos;en reste devant la cible</translation>
    </message>
    <message>
        <source>Peel off</source>
        <translation>Éplucher depuis</translation>
    </message>
    <message>
        <source>Which side of the patient the layer is peeled off</source>
        <translation>De quel côté du patient la couche est épluchée</translation>
    </message>
    <message>
        <source>Cut turned by</source>
        <translation>Coupe tournée de</translation>
    </message>
    <message>
        <source>Turns the cut through the layer: at 0 it runs from head to foot, or from front to back where the layer is peeled off above or below</source>
        <translation>Tourne la coupe de la couche&#xa0;: à 0 elle va de la tête aux pieds, ou d&apos;avant en arrière si on épluche en haut ou en bas</translation>
    </message>
    <message>
        <source>Layer down to</source>
        <translation>Couche jusqu&apos;à</translation>
    </message>
    <message>
        <source>How deep the layer reaches: at 0 it ends just in front of the focus, at 1 just behind it</source>
        <translation>Profondeur de la couche&#xa0;: à 0 elle finit juste devant la cible, à 1 juste derrière</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rouleau</translation>
    </message>
    <message>
        <source>Radius of the hollow in the roll: less rolls the layer up more tightly</source>
        <translation>Rayon du creux du rouleau&#xa0;: moins enroule plus serré</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>How far the opened window reaches beyond the focus on all its sides</source>
        <translation>De combien la fenêtre ouverte dépasse la cible de tous côtés</translation>
    </message>
    <message>
        <source>The front</source>
        <translation>L&apos;avant</translation>
    </message>
    <message>
        <source>The patient&apos;s anterior side</source>
        <translation>Le côté antérieur du patient</translation>
    </message>
    <message>
        <source>The back</source>
        <translation>L&apos;arrière</translation>
    </message>
    <message>
        <source>The patient&apos;s posterior side</source>
        <translation>Le côté postérieur du patient</translation>
    </message>
    <message>
        <source>The left</source>
        <translation>La gauche</translation>
    </message>
    <message>
        <source>The patient&apos;s left side</source>
        <translation>Le côté gauche du patient</translation>
    </message>
    <message>
        <source>The right</source>
        <translation>La droite</translation>
    </message>
    <message>
        <source>The patient&apos;s right side</source>
        <translation>Le côté droit du patient</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>The patient&apos;s superior side</source>
        <translation>Le côté supérieur du patient</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Dessous</translation>
    </message>
    <message>
        <source>The patient&apos;s inferior side</source>
        <translation>Le côté inférieur du patient</translation>
    </message>
    <message>
        <source>Sculpting</source>
        <translation>Sculpture</translation>
    </message>
    <message>
        <source>Nothing opens by itself: you carve the volume with a ball, a box or a saw until the focus shows (Wang and Kaufman 1995)</source>
        <translation>Rien ne s&apos;ouvre tout seul&#xa0;: vous sculptez le volume à la boule, à la boîte ou à la scie jusqu&apos;à voir la cible (Wang et Kaufman 1995)</translation>
    </message>
    <message>
        <source>Ghosted selection</source>
        <translation>Sélection fantôme</translation>
    </message>
    <message>
        <source>Nothing is cut away: in front of the focus, and in the opening around it, what is flat gives way and edges stay, like a ghost of it; what is in focus stays as it is (Bruckner and Gröller 2005)</source>
        <translation>Rien n&apos;est enlevé&#xa0;: devant la cible et dans l&apos;ouverture autour, ce qui est plat s&apos;efface et les arêtes restent, comme un fantôme&#xa0;; la cible reste telle quelle (Bruckner et Gröller 2005)</translation>
    </message>
    <message>
        <source>Ghosting</source>
        <translation>Effet fantôme</translation>
    </message>
    <message>
        <source>How much of what is flat in front of the selection gives way; 0 fades nothing</source>
        <translation>Part de ce qui est plat devant la sélection qui s&apos;efface&#xa0;; 0 n&apos;estompe rien</translation>
    </message>
    <message>
        <source>Edges from</source>
        <translation>Arêtes dès</translation>
    </message>
    <message>
        <source>Gradient of which half stays in front of the selection, as a share of the steepest that the volume can have: less keeps fainter edges</source>
        <translation>Gradient dont la moitié reste devant la sélection, en part du plus raide possible dans le volume&#xa0;: moins garde des arêtes plus faibles</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Contours</translation>
    </message>
    <message>
        <source>How much edges that face you give way, too, so that outlines stay in front of the selection</source>
        <translation>Part des arêtes qui vous font face et qui s&apos;effacent aussi, pour que les contours restent devant la sélection</translation>
    </message>
    <message>
        <source>Walls of slices</source>
        <translation>Parois de coupes</translation>
    </message>
    <message>
        <source>The adaptive cutaway with the slices at the crosshair as walls: behind the volume, or inside the opening (Tory and Swindells 2003)</source>
        <translation>L&apos;écorché adaptatif avec les coupes au réticule comme parois&#xa0;: derrière le volume, ou dans l&apos;ouverture (Tory et Swindells 2003)</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Parois</translation>
    </message>
    <message>
        <source>Where the walls of slices stand</source>
        <translation>Où se trouvent les parois de coupes</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Whether the axial slice at the crosshair is a wall</source>
        <translation>Si la coupe axiale au réticule est une paroi</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Whether the sagittal slice at the crosshair is a wall</source>
        <translation>Si la coupe sagittale au réticule est une paroi</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
    <message>
        <source>Whether the coronal slice at the crosshair is a wall</source>
        <translation>Si la coupe coronale au réticule est une paroi</translation>
    </message>
    <message>
        <source>Whether the labels&apos; outlines are drawn on the walls</source>
        <translation>Si les contours des étiquettes sont dessinés sur les parois</translation>
    </message>
    <message>
        <source>Around the volume</source>
        <translation>Autour du volume</translation>
    </message>
    <message>
        <source>Behind the volume, like the walls of a room</source>
        <translation>Derrière le volume, comme les murs d&apos;une pièce</translation>
    </message>
    <message>
        <source>Inside the opening</source>
        <translation>Dans l&apos;ouverture</translation>
    </message>
    <message>
        <source>Where the slices lie, in the space that the opening removed; before the focus there is none</source>
        <translation>Là où se trouvent les coupes, dans l&apos;espace dégagé par l&apos;ouverture&#xa0;; devant la cible il n&apos;y en a pas</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>pixels</translation>
    </message>
    <message>
        <source>millimetres at the focus</source>
        <translation>millimètres à la cible</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Boule</translation>
    </message>
    <message>
        <source>A ball, where the mouse goes</source>
        <translation>Une boule, là où passe la souris</translation>
    </message>
    <message>
        <source>A box that faces you, where the mouse goes</source>
        <translation>Une boîte face à vous, là où passe la souris</translation>
    </message>
    <message>
        <source>Saw</source>
        <translation>Scie</translation>
    </message>
    <message>
        <source>A blade along the stroke, away from you; a stroke that comes back to its start takes out what it encloses</source>
        <translation>Une lame le long du trait, vers l&apos;avant&#xa0;; un trait qui revient à son début enlève ce qu&apos;il entoure</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>A plane through the stroke that removes what lies to the right of it, and that you bend by dragging</source>
        <translation>Un plan par le trait, qui enlève ce qui est à sa droite et que l&apos;on courbe en glissant</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurer</translation>
    </message>
    <message>
        <source>Brings back what the opening removed</source>
        <translation>Ramène ce que l&apos;ouverture a enlevé</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Opens further, away from the eye</source>
        <translation>Ouvre davantage, vers l&apos;avant</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>Estomper</translation>
    </message>
    <message>
        <source>Shows less of the context&apos;s edges over the focus</source>
        <translation>Montre moins d&apos;arêtes du contexte sur la cible</translation>
    </message>
    <message>
        <source>Strengthen</source>
        <translation>Renforcer</translation>
    </message>
    <message>
        <source>Shows more of the context&apos;s edges over the focus</source>
        <translation>Montre plus d&apos;arêtes du contexte sur la cible</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Contexte</translation>
    </message>
    <message>
        <source>Cut away where it hides the focus</source>
        <translation>Enlevé là où il cache la cible</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Masquée</translation>
    </message>
    <message>
        <source>Left out of 3-D pictures; slices show its voxels</source>
        <translation>Absente des images 3D&#xa0;; les coupes montrent ses voxels</translation>
    </message>
    <message>
        <source>Protected</source>
        <translation>Protégée</translation>
    </message>
    <message>
        <source>Never cut away, even where it hides the focus</source>
        <translation>Jamais enlevée, même là où elle cache la cible</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>What is connected to the click by values near its own</source>
        <translation>Ce qui est relié au clic par des valeurs proches</translation>
    </message>
    <message>
        <source>Tissues</source>
        <translation>Tissus</translation>
    </message>
    <message>
        <source>What belongs to the clicked tissue more than to any other of the volume</source>
        <translation>Ce qui appartient au tissu cliqué plus qu&apos;à tout autre du volume</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>Droit</translation>
    </message>
    <message>
        <source>Straight lines between voxels: coarse scans show terraces</source>
        <translation>Droites entre voxels&#xa0;: les acquisitions grossières montrent des terrasses</translation>
    </message>
    <message>
        <source>Curved</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Smooth curves through every voxel, its noise as well: takes more memory and time</source>
        <translation>Courbes lisses par chaque voxel, son bruit compris&#xa0;: prend plus de mémoire et de temps</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Lissé</translation>
    </message>
    <message>
        <source>Smooth curves near the voxels: fewer terraces and less noise, but softer detail</source>
        <translation>Courbes lisses près des voxels&#xa0;: moins de terrasses et de bruit, mais détails adoucis</translation>
    </message>
    <message>
        <source>Smoothed more</source>
        <translation>Plus lissé</translation>
    </message>
    <message>
        <source>Smooth curves near means over five voxels: no terraces in coarse scans, but fine detail is lost</source>
        <translation>Courbes lisses près des moyennes de cinq voxels&#xa0;: pas de terrasses, mais les détails fins se perdent</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Smoothed where voxels are coarse and not too many, else straight</source>
        <translation>Lissé si les voxels sont gros et pas trop nombreux, sinon droit</translation>
    </message>
    <message>
        <source>One colour</source>
        <translation>Une couleur</translation>
    </message>
    <message>
        <source>The background&apos;s colour everywhere</source>
        <translation>La couleur du fond partout</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Dégradé</translation>
    </message>
    <message>
        <source>From the background&apos;s colour at the bottom to another at the top</source>
        <translation>De la couleur du fond en bas à une autre en haut</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exact</translation>
    </message>
    <message>
        <source>As the labels have it, with the steps of their voxels</source>
        <translation>Telle que dans les étiquettes, avec les marches de leurs voxels</translation>
    </message>
    <message>
        <source>Lightly smoothed</source>
        <translation>Légèrement lissé</translation>
    </message>
    <message>
        <source>Without the steps of single voxels</source>
        <translation>Sans les marches de chaque voxel</translation>
    </message>
    <message>
        <source>Strongly smoothed</source>
        <translation>Fortement lissé</translation>
    </message>
    <message>
        <source>Without terraces of several voxels</source>
        <translation>Sans terrasses de plusieurs voxels</translation>
    </message>
    <message>
        <source>One ray a pixel</source>
        <translation>Un rayon par pixel</translation>
    </message>
    <message>
        <source>Edges show the steps of the pixels</source>
        <translation>Les bords montrent les marches des pixels</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisse</translation>
    </message>
    <message>
        <source>Several rays for each pixel that an edge runs through</source>
        <translation>Plusieurs rayons pour chaque pixel traversé par un bord</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>perspective</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>orthographique</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>ébauche</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normale</translation>
    </message>
    <message>
        <source>high</source>
        <translation>haute</translation>
    </message>
    <message>
        <source>Open the context around the focus</source>
        <translation>Ouvrir le contexte autour de la cible</translation>
    </message>
    <message>
        <source>Whether the context is cut away around the focus</source>
        <translation>Si le contexte autour de la cible est enlevé</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Ouverture</translation>
    </message>
    <message>
        <source>How far the opening reaches beyond the focus (w_open)</source>
        <translation>De combien l&apos;ouverture dépasse la cible (w_open)</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Bordure</translation>
    </message>
    <message>
        <source>Width of the line around the opening (w_border)</source>
        <translation>Largeur de la ligne autour de l&apos;ouverture (w_border)</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Unit of both widths: pixels of the screen, or mm at the depth of the focus, which keep the opening still while zooming</source>
        <translation>Unité des deux largeurs&#xa0;: pixels de l&apos;écran, ou mm à la profondeur de la cible, qui gardent l&apos;ouverture fixe en zoomant</translation>
    </message>
    <message>
        <source>Border colour</source>
        <translation>Couleur de la bordure</translation>
    </message>
    <message>
        <source>Colour of the line around the opening</source>
        <translation>Couleur de la ligne autour de l&apos;ouverture</translation>
    </message>
    <message>
        <source>Axis offset</source>
        <translation>Décalage d&apos;axe</translation>
    </message>
    <message>
        <source>Angle between the opening&apos;s axis and the line of sight, so that its depth shows</source>
        <translation>Angle entre l&apos;axe de l&apos;ouverture et la ligne de visée, pour que sa profondeur se voie</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>To which side of the picture the opening&apos;s axis leans: 0 is the right, 90 the top</source>
        <translation>Vers quel côté de l&apos;image penche l&apos;axe de l&apos;ouverture&#xa0;: 0 est la droite, 90 le haut</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>How strongly the edges of the removed context are drawn over the focus; 0 draws none</source>
        <translation>Force des arêtes du contexte enlevé dessinées sur la cible&#xa0;; 0 n&apos;en dessine aucune</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Courbure</translation>
    </message>
    <message>
        <source>How much bends of the context&apos;s surface count as edges: eyes, nose, ears</source>
        <translation>Combien les courbures de la surface du contexte comptent comme arêtes&#xa0;: yeux, nez, oreilles</translation>
    </message>
    <message>
        <source>Silhouette</source>
        <translation>Silhouette</translation>
    </message>
    <message>
        <source>How much the context&apos;s outlines, where its surface is seen edge-on, count as edges</source>
        <translation>Combien les contours du contexte, là où sa surface est vue par la tranche, comptent comme arêtes</translation>
    </message>
    <message>
        <source>Illumination</source>
        <translation>Éclairage</translation>
    </message>
    <message>
        <source>How much the light on the context&apos;s surface shades its edges; 0 draws them flat</source>
        <translation>Combien la lumière sur la surface du contexte ombre ses arêtes&#xa0;; 0 les dessine à plat</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Couleur propre</translation>
    </message>
    <message>
        <source>How much the edges take the context&apos;s own colour</source>
        <translation>Combien les arêtes prennent la couleur du contexte</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturation</translation>
    </message>
    <message>
        <source>How saturated the context&apos;s own colour is in its edges</source>
        <translation>Saturation de la couleur du contexte dans ses arêtes</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Part</translation>
    </message>
    <message>
        <source>How much of the focus the edges may cover at most: the strongest stay; 1 keeps all</source>
        <translation>Part de la cible que les arêtes peuvent couvrir au plus&#xa0;: les plus fortes restent&#xa0;; 1 les garde toutes</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Colour of the context&apos;s edges</source>
        <translation>Couleur des arêtes du contexte</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Ombrage</translation>
    </message>
    <message>
        <source>Whether surfaces are lit by the gradient of the values</source>
        <translation>Si les surfaces sont éclairées selon le gradient des valeurs</translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation>Ambiante</translation>
    </message>
    <message>
        <source>Light from all sides</source>
        <translation>Lumière de tous côtés</translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation>Diffuse</translation>
    </message>
    <message>
        <source>Light that a matt surface scatters</source>
        <translation>Lumière que diffuse une surface mate</translation>
    </message>
    <message>
        <source>Specular</source>
        <translation>Spéculaire</translation>
    </message>
    <message>
        <source>Strength of the highlights</source>
        <translation>Force des reflets</translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation>Brillance</translation>
    </message>
    <message>
        <source>Exponent of the highlights: a larger one makes them smaller and sharper</source>
        <translation>Exposant des reflets&#xa0;: plus grand, il les rend plus petits et plus nets</translation>
    </message>
    <message>
        <source>Light azimuth</source>
        <translation>Azimut de la lumière</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 is behind the viewer, 90 the right of the picture</source>
        <translation>D&apos;où vient la lumière&#xa0;: 0 est derrière l&apos;observateur, 90 la droite de l&apos;image</translation>
    </message>
    <message>
        <source>Light elevation</source>
        <translation>Hauteur de la lumière</translation>
    </message>
    <message>
        <source>How high the light stands: 90 is the top of the picture, -90 the bottom</source>
        <translation>Hauteur de la lumière&#xa0;: 90 est le haut de l&apos;image, -90 le bas</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Occlusion</translation>
    </message>
    <message>
        <source>How dark hollows are, which what is around them hides from the light from all sides; 0 leaves them as bright as the rest and costs nothing</source>
        <translation>À quel point les creux, privés de la lumière ambiante par ce qui les entoure, sont sombres&#xa0;; 0 les laisse aussi clairs que le reste et ne coûte rien</translation>
    </message>
    <message>
        <source>Soft shadow</source>
        <translation>Ombre douce</translation>
    </message>
    <message>
        <source>How dark the shadows are that the volume, as it is cut open, casts on itself; 0 casts none and costs nothing</source>
        <translation>À quel point sont sombres les ombres que le volume ouvert porte sur lui-même&#xa0;; 0 n&apos;en porte aucune et ne coûte rien</translation>
    </message>
    <message>
        <source>Colour of a focus of values; labels have colours of their own</source>
        <translation>Couleur d&apos;une cible par valeurs&#xa0;; les étiquettes ont les leurs</translation>
    </message>
    <message>
        <source>Extinction</source>
        <translation>Extinction</translation>
    </message>
    <message>
        <source>Extinction coefficient of the focus</source>
        <translation>Coefficient d&apos;extinction de la cible</translation>
    </message>
    <message>
        <source>1/mm</source>
        <translation>1/mm</translation>
    </message>
    <message>
        <source>Smallest island</source>
        <translation>Plus petit îlot</translation>
    </message>
    <message>
        <source>Volume below which an island of a focus of values is left out</source>
        <translation>Volume sous lequel un îlot d&apos;une cible par valeurs est omis</translation>
    </message>
    <message>
        <source>mm³</source>
        <translation>mm³</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Moves the whole transfer function along the values</source>
        <translation>Décale toute la fonction de transfert le long des valeurs</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fond</translation>
    </message>
    <message>
        <source>Colour behind the volume; of a gradient, at the bottom</source>
        <translation>Couleur derrière le volume&#xa0;; d&apos;un dégradé, celle du bas</translation>
    </message>
    <message>
        <source>Backdrop</source>
        <translation>Type de fond</translation>
    </message>
    <message>
        <source>Whether one colour is behind the volume, or a gradient of two</source>
        <translation>Si derrière le volume se trouve une couleur ou un dégradé de deux</translation>
    </message>
    <message>
        <source>Top of the gradient</source>
        <translation>Haut du dégradé</translation>
    </message>
    <message>
        <source>Colour of a gradient behind the volume at the top</source>
        <translation>Couleur du haut d&apos;un dégradé derrière le volume</translation>
    </message>
    <message>
        <source>Hide the table</source>
        <translation>Masquer la table</translation>
    </message>
    <message>
        <source>Whether 3-D pictures of a CT leave out the scanner&apos;s table, head rest and cushions</source>
        <translation>Si les images 3D d&apos;une TDM omettent la table, l&apos;appui-tête et les coussins du scanner</translation>
    </message>
    <message>
        <source>Between voxels</source>
        <translation>Entre voxels</translation>
    </message>
    <message>
        <source>How 3-D pictures fill in the values between the voxels</source>
        <translation>Comment les images 3D comblent les valeurs entre les voxels</translation>
    </message>
    <message>
        <source>Label surfaces</source>
        <translation>Surfaces</translation>
    </message>
    <message>
        <source>How far 3-D pictures smooth the surface of labels in focus: it stays within the voxels that it passes through, and keeps its volume</source>
        <translation>De combien les images 3D lissent la surface des étiquettes ciblées&#xa0;: elle reste dans les voxels qu&apos;elle traverse et garde son volume</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Bords</translation>
    </message>
    <message>
        <source>Whether 3-D pictures at rest smooth outlines and the rims of what is cut</source>
        <translation>Si les images 3D au repos lissent les contours et les bords de coupe</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>What the stroke does</source>
        <translation>Ce que fait le trait</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Rayon du pinceau</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Douceur</translation>
    </message>
    <message>
        <source>Share of the radius over which the effect fades out</source>
        <translation>Part du rayon sur laquelle l&apos;effet s&apos;estompe</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>How far along the ray Restore and Open move its start at most</source>
        <translation>De combien Restaurer et Ouvrir déplacent au plus le départ du rayon</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Quantité</translation>
    </message>
    <message>
        <source>How much of the context&apos;s edges Fade takes or Strengthen adds</source>
        <translation>Combien Estomper retire ou Renforcer ajoute aux arêtes du contexte</translation>
    </message>
    <message>
        <source>To the surface</source>
        <translation>Jusqu&apos;à la surface</translation>
    </message>
    <message>
        <source>Whether Restore reaches to the context&apos;s first surface, however deep that lies</source>
        <translation>Si Restaurer va jusqu&apos;à la première surface du contexte, quelle que soit sa profondeur</translation>
    </message>
    <message>
        <source>May cover the focus</source>
        <translation>Peut couvrir la cible</translation>
    </message>
    <message>
        <source>Whether restored context may hide the focus</source>
        <translation>Si le contexte restauré peut cacher la cible</translation>
    </message>
    <message>
        <source>Whether the stroke is kept without effect</source>
        <translation>Si le trait est gardé sans effet</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>View in which it shows: 0 for C1, 1 for C2, -1 for both</source>
        <translation>Vue où il apparaît&#xa0;: 0 pour C1, 1 pour C2, -1 pour les deux</translation>
    </message>
    <message>
        <source>Edges and border</source>
        <translation>Arêtes et bordure</translation>
    </message>
    <message>
        <source>Cut alone</source>
        <translation>Coupe seule</translation>
    </message>
    <message>
        <source>Context&apos;s edges</source>
        <translation>Arêtes du contexte</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>A little gloss</source>
        <translation>Un peu de brillance</translation>
    </message>
    <message>
        <source>Matte</source>
        <translation>Mat</translation>
    </message>
    <message>
        <source>Without highlights, as plaster</source>
        <translation>Sans reflets, comme du plâtre</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Os</translation>
    </message>
    <message>
        <source>Soft shades and a wide sheen</source>
        <translation>Ombres douces et large lustre</translation>
    </message>
    <message>
        <source>Wet</source>
        <translation>Humide</translation>
    </message>
    <message>
        <source>Small and strong highlights, as moist tissue in an operation</source>
        <translation>Reflets petits et forts, comme un tissu humide en opération</translation>
    </message>
    <message>
        <source>Technical</source>
        <translation>Technique</translation>
    </message>
    <message>
        <source>Even light that keeps colours to be told apart</source>
        <translation>Lumière égale qui garde les couleurs distinctes</translation>
    </message>
    <message>
        <source>the point lies outside of the volume</source>
        <translation>le point est hors du volume</translation>
    </message>
    <message>
        <source>the point lies in air, where there is no structure</source>
        <translation>le point est dans l&apos;air, où il n&apos;y a pas de structure</translation>
    </message>
    <message>
        <source>no region can be grown from the point</source>
        <translation>aucune région ne peut croître depuis le point</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Tête</translation>
    </message>
    <message>
        <source>Torso</source>
        <translation>Torse</translation>
    </message>
    <message>
        <source>CT angio</source>
        <translation>TDM angio</translation>
    </message>
    <message>
        <source>CT bone</source>
        <translation>TDM os</translation>
    </message>
    <message>
        <source>CT lung</source>
        <translation>TDM poumon</translation>
    </message>
    <message>
        <source>CT plain</source>
        <translation>TDM simple</translation>
    </message>
    <message>
        <source>CT skin</source>
        <translation>TDM peau</translation>
    </message>
    <message>
        <source>CT soft tissue</source>
        <translation>TDM parties molles</translation>
    </message>
    <message>
        <source>MR angio</source>
        <translation>IRM angio</translation>
    </message>
    <message>
        <source>MR bright</source>
        <translation>IRM claire</translation>
    </message>
    <message>
        <source>MR T1</source>
        <translation>IRM T1</translation>
    </message>
    <message>
        <source>MR T2</source>
        <translation>IRM T2</translation>
    </message>
    <message>
        <source>MR</source>
        <translation>IRM</translation>
    </message>
    <message>
        <source>PET</source>
        <translation>TEP</translation>
    </message>
    <message>
        <source>Ultrasound</source>
        <translation>Échographie</translation>
    </message>
    <message>
        <source>making the phantom</source>
        <translation>création du fantôme</translation>
    </message>
    <message>
        <source>unpacking</source>
        <translation>décompression</translation>
    </message>
    <message>
        <source>comparing contents</source>
        <translation>comparaison des contenus</translation>
    </message>
    <message>
        <source>the only one whose geometry is plausible</source>
        <translation>la seule dont la géométrie est plausible</translation>
    </message>
    <message>
        <source>the only one that is no overview, capture or reformat</source>
        <translation>la seule qui n&apos;est ni repérage, ni capture, ni reformatage</translation>
    </message>
    <message>
        <source>the only %1</source>
        <translation>la seule de son genre (%1)</translation>
    </message>
    <message>
        <source>the thinnest %1, %2</source>
        <translation>la plus fine de son genre (%1), %2</translation>
    </message>
    <message>
        <source>of the thinnest ones, %1, the one of most voxels</source>
        <translation>parmi les plus fines, %1, celle qui a le plus de voxels</translation>
    </message>
    <message>
        <source>the %1 of most voxels</source>
        <translation>celle qui a le plus de voxels (%1)</translation>
    </message>
    <message>
        <source>of equal ones the first by its number, %1</source>
        <translation>parmi les égales, la première par son numéro, %1</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>stack of slices</source>
        <translation>pile de coupes</translation>
    </message>
    <message>
        <source>image</source>
        <translation>image</translation>
    </message>
    <message>
        <source>reading headers</source>
        <translation>lecture des en-têtes</translation>
    </message>
    <message>
        <source>reading slices</source>
        <translation>lecture des coupes</translation>
    </message>
    <message>
        <source>filling contours</source>
        <translation>remplissage des contours</translation>
    </message>
    <message>
        <source>reading segments</source>
        <translation>lecture des segments</translation>
    </message>
    <message>
        <source>writing segments</source>
        <translation>écriture des segments</translation>
    </message>
    <message>
        <source>reading voxels</source>
        <translation>lecture des voxels</translation>
    </message>
    <message>
        <source>growing the region</source>
        <translation>croissance de la région</translation>
    </message>
    <message>
        <source>looking for moved data</source>
        <translation>recherche de données déplacées</translation>
    </message>
    <message>
        <source>finding the focus</source>
        <translation>recherche de la cible</translation>
    </message>
    <message>
        <source>extracting the surface</source>
        <translation>extraction de la surface</translation>
    </message>
    <message>
        <source>smoothing the surface</source>
        <translation>lissage de la surface</translation>
    </message>
    <message>
        <source>Editing the label</source>
        <translation>Modification de l&apos;étiquette</translation>
    </message>
    <message>
        <source>acquired volume</source>
        <translation>volume acquis</translation>
    </message>
    <message>
        <source>acquired stack of slices</source>
        <translation>pile de coupes acquise</translation>
    </message>
    <message>
        <source>acquired image</source>
        <translation>image acquise</translation>
    </message>
    <message>
        <source>volume that is no overview, capture or reformat</source>
        <translation>volume qui n&apos;est ni repérage, ni capture, ni reformatage</translation>
    </message>
    <message>
        <source>stack of slices that is no overview, capture or reformat</source>
        <translation>pile de coupes qui n&apos;est ni repérage, ni capture, ni reformatage</translation>
    </message>
    <message>
        <source>image that is no overview, capture or reformat</source>
        <translation>image qui n&apos;est ni repérage, ni capture, ni reformatage</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Comme le bureau</translation>
    </message>
    <message>
        <source>How deep the focus lies; below 0 prefers views with little in front of it.
vd1 = mean depth of the focus&apos;s pixels / diameter of the model&apos;s sphere</source>
        <translation>Profondeur de la cible&#xa0;; sous 0, préfère les vues avec peu de choses devant.
vd1 = profondeur moyenne des pixels de la cible / diamètre de la sphère du modèle</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>How large the focus is in the picture.
vd2 = pixels of the focus / pixels of the picture</source>
        <translation>Taille de la cible dans l&apos;image.
vd2 = pixels de la cible / pixels de l&apos;image</translation>
    </message>
    <message>
        <source>Centring</source>
        <translation>Centrage</translation>
    </message>
    <message>
        <source>How near to the middle of the picture it is.
vd3 = 1 − distance of its centroid from the middle / distance of a corner</source>
        <translation>Proximité du milieu de l&apos;image.
vd3 = 1 − distance de son centre de gravité au milieu / distance d&apos;un coin</translation>
    </message>
    <message>
        <source>Cut ends</source>
        <translation>Extrémités coupées</translation>
    </message>
    <message>
        <source>Below 0 avoids looking at the focus through a face where the scan cuts the body off.
Share of the focus&apos;s pixels whose rays enter the volume inside the body</source>
        <translation>Sous 0, évite de regarder la cible à travers une face où l&apos;acquisition coupe le corps.
Part des pixels de la cible dont les rayons entrent dans le volume à l&apos;intérieur du corps</translation>
    </message>
    <message>
        <source>Evenness</source>
        <translation>Uniformité</translation>
    </message>
    <message>
        <source>How much of its surface is seen.
Viewpoint entropy −Σ p log p of the seen surface points, over its maximum (Bordoloi, Shen 2005)</source>
        <translation>Part visible de sa surface.
Entropie du point de vue −Σ p log p des points vus, sur son maximum (Bordoloi, Shen 2005)</translation>
    </message>
    <message>
        <source>Typical</source>
        <translation>Typique</translation>
    </message>
    <message>
        <source>How typical the view is of all views.
1 − Σ p(o|v) log(p(o|v) / p(o)) over its maximum (Viola et al. 2006)</source>
        <translation>À quel point la vue est typique de toutes.
1 − Σ p(o|v) log(p(o|v) / p(o)) sur son maximum (Viola et al. 2006)</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>Stable</translation>
    </message>
    <message>
        <source>How little changes when the camera moves a bit.
1 − Jensen–Shannon divergence to the eight nearest views</source>
        <translation>Peu de changement quand la caméra bouge un peu.
1 − divergence de Jensen-Shannon avec les huit vues voisines</translation>
    </message>
    <message>
        <source>Standard view</source>
        <translation>Vue standard</translation>
    </message>
    <message>
        <source>How near the view is to anterior, left, superior …: a little decides between equally good views.
Cosine of the angle to the nearest of the six</source>
        <translation>Proximité de la vue avec antérieure, gauche, supérieure …&#xa0;: un peu départage des vues aussi bonnes.
Cosinus de l&apos;angle avec la plus proche des six</translation>
    </message>
    <message>
        <source>Not through cut ends</source>
        <translation>Pas à travers les extrémités coupées</translation>
    </message>
    <message>
        <source>No view within 45° of an end of the scan where the body goes on, while another one shows at least two thirds as much of the focus</source>
        <translation>Aucune vue à moins de 45° d&apos;une extrémité de l&apos;acquisition où le corps continue, si une autre montre au moins deux tiers autant de la cible</translation>
    </message>
    <message>
        <source>From around before from above</source>
        <translation>D&apos;autour avant d&apos;en haut</translation>
    </message>
    <message>
        <source>From the front, from behind, the left or the right rather than from above or below, where both show about as much</source>
        <translation>De face, de dos, de gauche ou de droite plutôt que d&apos;en haut ou d&apos;en bas, si les deux montrent à peu près autant</translation>
    </message>
    <message>
        <source>Thin stacks from the front</source>
        <translation>Piles minces de face</translation>
    </message>
    <message>
        <source>A stack of a few slices, or one much thinner than wide, is seen from the side from which its slices are shown, not edge-on</source>
        <translation>Une pile de quelques coupes, ou bien plus mince que large, est vue du côté où ses coupes s&apos;affichent, pas par la tranche</translation>
    </message>
    <message>
        <source>From the near side</source>
        <translation>Du côté proche</translation>
    </message>
    <message>
        <source>Language (at the next start)</source>
        <translation>Langue (au prochain démarrage)</translation>
    </message>
    <message>
        <source>Language of the window&apos;s texts and numbers; it changes when Fenestra starts again</source>
        <translation>Langue des textes et des nombres de la fenêtre&#xa0;; elle change au redémarrage de Fenestra</translation>
    </message>
    <message>
        <source>Usual side</source>
        <translation>Côté habituel</translation>
    </message>
    <message>
        <source>How usual the view is: from the front rather than from the side, from behind, from above or below</source>
        <translation>À quel point la vue est habituelle&#xa0;: de face plutôt que de côté, de dos, d&apos;en haut ou d&apos;en bas</translation>
    </message>
    <message>
        <source>Last view</source>
        <translation>Dernière vue</translation>
    </message>
    <message>
        <source>How near the view is to the present one, so that it does not jump</source>
        <translation>Proximité avec la vue actuelle, pour éviter un saut</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>How well the view shows the structure&apos;s shape around the point: onto what is flat, across what is long</source>
        <translation>Comment la vue montre la forme de la structure autour du point&#xa0;: de face si plate, en travers si longue</translation>
    </message>
    <message>
        <source>Unhidden</source>
        <translation>Dégagée</translation>
    </message>
    <message>
        <source>How little hides the structure around the point, before anything is cut away</source>
        <translation>Combien peu cache la structure autour du point, avant toute découpe</translation>
    </message>
    <message>
        <source>Neurological convention</source>
        <translation>Convention neurologique</translation>
    </message>
    <message>
        <source>Axial and coronal slices show the patient&apos;s left on the left; otherwise it is on the right, as radiologists have it</source>
        <translation>Les coupes axiales et coronales montrent la gauche du patient à gauche&#xa0;; sinon à droite, comme en radiologie</translation>
    </message>
    <message>
        <source>Objects of archives, at most</source>
        <translation>Objets des archives, au plus</translation>
    </message>
    <message>
        <source>Disk space for what was retrieved from archive servers: the series used longest ago go first</source>
        <translation>Espace disque pour ce qui a été récupéré des serveurs d&apos;archives&#xa0;: les séries inutilisées depuis le plus longtemps partent d&apos;abord</translation>
    </message>
    <message>
        <source>GB</source>
        <translation>Go</translation>
    </message>
    <message>
        <source>de-identifying</source>
        <translation>anonymisation</translation>
    </message>
    <message>
        <source>listing files</source>
        <translation>liste des fichiers</translation>
    </message>
    <message>
        <source>looking for faces</source>
        <translation>recherche des visages</translation>
    </message>
</context>
<context>
    <name>Slab</name>
    <message>
        <source>MIP</source>
        <translation>MIP</translation>
    </message>
    <message>
        <source>MinIP</source>
        <translation>MinIP</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %L2 mm</translation>
    </message>
</context>
<context>
    <name>StructureMenu</name>
    <message>
        <source>Focus on %1</source>
        <translation>Cibler %1</translation>
    </message>
    <message>
        <source>Take %1 out of the focus</source>
        <translation>Retirer %1 de la cible</translation>
    </message>
    <message>
        <source>Add %1 to the focus</source>
        <translation>Ajouter %1 à la cible</translation>
    </message>
    <message>
        <source>Grow a region from here</source>
        <translation>Faire croître une région d&apos;ici</translation>
    </message>
    <message>
        <source>Add this to the region</source>
        <translation>Ajouter ceci à la région</translation>
    </message>
    <message>
        <source>Take this away from the region</source>
        <translation>Retirer ceci de la région</translation>
    </message>
    <message>
        <source>Crosshair here</source>
        <translation>Réticule ici</translation>
    </message>
    <message>
        <source>No focus</source>
        <translation>Aucune cible</translation>
    </message>
</context>
<context>
    <name>ViewArea</name>
    <message>
        <source>&amp;Five views</source>
        <translation>&amp;Cinq vues</translation>
    </message>
    <message>
        <source>C&amp;1 and C2</source>
        <translation>C&amp;1 et C2</translation>
    </message>
    <message>
        <source>&amp;3-D large, three slices</source>
        <translation>&amp;3D en grand, trois coupes</translation>
    </message>
    <message>
        <source>&amp;Slices alone</source>
        <translation>Coupes &amp;seules</translation>
    </message>
    <message>
        <source>&amp;Axial large</source>
        <translation>&amp;Axial en grand</translation>
    </message>
    <message>
        <source>Four: C1 and slices</source>
        <translation>Quatre&#xa0;: C1 et coupes</translation>
    </message>
    <message>
        <source>C1 &amp;beside axial</source>
        <translation>C1 à côté &amp;d&apos;axial</translation>
    </message>
</context>
<context>
    <name>WayOut</name>
    <message>
        <source>File → Choose series has the others</source>
        <translation>Fichier → Choisir la série contient les autres</translation>
    </message>
    <message>
        <source>it holds one volume: open it without a time point</source>
        <translation>il contient un seul volume&#xa0;: ouvrez-le sans instant</translation>
    </message>
    <message>
        <source>open it without naming a series; File → Choose series then lists those that are there</source>
        <translation>ouvrez-le sans indiquer de série&#xa0;; Fichier → Choisir la série liste alors celles qui existent</translation>
    </message>
    <message>
        <source>open it as a volume: a dialog asks for the size</source>
        <translation>ouvrez-le comme volume&#xa0;: un dialogue demande la taille</translation>
    </message>
    <message>
        <source>File → Size of the voxels says otherwise</source>
        <translation>Fichier → Taille des voxels permet de corriger</translation>
    </message>
    <message>
        <source>open it without a size of voxels, which TIFF and raw files need</source>
        <translation>ouvrez-le sans taille de voxels, que seuls TIFF et fichiers bruts demandent</translation>
    </message>
    <message>
        <source>File → Kind of values says otherwise</source>
        <translation>Fichier → Nature des valeurs permet de corriger</translation>
    </message>
    <message>
        <source>put the file into the folder of its header</source>
        <translation>placez le fichier dans le dossier de son en-tête</translation>
    </message>
    <message>
        <source>open it as it is stored: Load as is, in the notice about its slices</source>
        <translation>ouvrez-le tel qu&apos;il est stocké&#xa0;: Charger tel quel, dans l&apos;avis sur ses coupes</translation>
    </message>
    <message>
        <source>DICOM, NIfTI, NRRD, MetaImage, MGH, Analyze and TIFF are recognised by content</source>
        <translation>DICOM, NIfTI, NRRD, MetaImage, MGH, Analyze et TIFF sont reconnus par leur contenu</translation>
    </message>
    <message>
        <source>&quot;Hide the table&quot; in the panel Context brings it back</source>
        <translation>«&#xa0;Masquer la table&#xa0;» dans le panneau Contexte la ramène</translation>
    </message>
    <message>
        <source>open a label map with File → Open labels</source>
        <translation>ouvrez une carte d&apos;étiquettes avec Fichier → Ouvrir des étiquettes</translation>
    </message>
    <message>
        <source>choose one in the panel Focus</source>
        <translation>choisissez-en une dans le panneau Cible</translation>
    </message>
    <message>
        <source>choose the labels of the focus in the panel Focus</source>
        <translation>choisissez les étiquettes de la cible dans le panneau Cible</translation>
    </message>
    <message>
        <source>open the session again with File → Open session, which asks where they are, or put them beside it</source>
        <translation>rouvrez la session avec Fichier → Ouvrir une session, qui demande où elles sont, ou placez-les à côté</translation>
    </message>
    <message>
        <source>open the session again with File → Open session, which asks where they are</source>
        <translation>rouvrez la session avec Fichier → Ouvrir une session, qui demande où elles sont</translation>
    </message>
    <message>
        <source>open it without saying how its volume is read</source>
        <translation>ouvrez-la sans dire comment son volume est lu</translation>
    </message>
    <message>
        <source>open it without files</source>
        <translation>ouvrez-la sans fichiers</translation>
    </message>
    <message>
        <source>raise the tolerance in the panel Focus</source>
        <translation>augmentez la tolérance dans le panneau Cible</translation>
    </message>
    <message>
        <source>click at another place, or take a point outside away</source>
        <translation>cliquez à un autre endroit, ou retirez un point extérieur</translation>
    </message>
    <message>
        <source>select more, or take less away</source>
        <translation>sélectionnez davantage, ou retirez moins</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Actions</name>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>&amp;User guide</source>
        <translation>&amp;Guide de l&apos;utilisateur</translation>
    </message>
    <message>
        <source>Guided &amp;tour</source>
        <translation>&amp;Visite guidée</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Touches et souris</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>&amp;About Fenestra</source>
        <translation>À &amp;propos de Fenestra</translation>
    </message>
    <message>
        <source>Open &amp;folder…</source>
        <translation>&amp;Ouvrir un dossier…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>Ouvrir &amp;un fichier…</translation>
    </message>
    <message>
        <source>Open &amp;labels…</source>
        <translation>Ou&amp;vrir des étiquettes…</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>Choose series…</source>
        <translation>Choisir la série…</translation>
    </message>
    <message>
        <source>Open s&amp;ession…</source>
        <translation>Ouvrir une &amp;session…</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>&amp;Enregistrer la session</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>Enregistrer &amp;la session sous…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Recent</source>
        <translation>&amp;Récents</translation>
    </message>
    <message>
        <source>&amp;Built-in phantoms</source>
        <translation>&amp;Fantômes intégrés</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Open a folder of &amp;masks…</source>
        <translation>Ouvrir un &amp;dossier de masques…</translation>
    </message>
    <message>
        <source>Open a &amp;table of labels…</source>
        <translation>Ouvrir une &amp;table d&apos;étiquettes…</translation>
    </message>
    <message>
        <source>Si&amp;ze of the voxels…</source>
        <translation>T&amp;aille des voxels…</translation>
    </message>
    <message>
        <source>&amp;Kind of values</source>
        <translation>&amp;Nature des valeurs</translation>
    </message>
    <message>
        <source>&amp;CT</source>
        <translation>&amp;TDM</translation>
    </message>
    <message>
        <source>&amp;MR</source>
        <translation>&amp;IRM</translation>
    </message>
    <message>
        <source>&amp;PET or SPECT</source>
        <translation>TEP &amp;ou TEMP</translation>
    </message>
    <message>
        <source>&amp;Ultrasound</source>
        <translation>É&amp;chographie</translation>
    </message>
    <message>
        <source>&amp;Other</source>
        <translation>&amp;Autre</translation>
    </message>
    <message>
        <source>Se&amp;gmentations of this series</source>
        <translation>Se&amp;gmentations de cette série</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xporter</translation>
    </message>
    <message>
        <source>A &amp;picture…</source>
        <translation>&amp;Image…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>A &amp;turntable…</source>
        <translation>&amp;Rotation complète…</translation>
    </message>
    <message>
        <source>All &amp;labels…</source>
        <translation>&amp;Toutes les étiquettes…</translation>
    </message>
    <message>
        <source>The &amp;focus as labels…</source>
        <translation>&amp;La cible en étiquettes…</translation>
    </message>
    <message>
        <source>The focus as a &amp;surface…</source>
        <translation>La &amp;cible en surface…</translation>
    </message>
    <message>
        <source>&amp;Measures as a table…</source>
        <translation>&amp;Mesures en tableau…</translation>
    </message>
    <message>
        <source>%1, name hidden</source>
        <translation>%1, nom masqué</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Rien pour l&apos;instant</translation>
    </message>
    <message>
        <source>Forget these</source>
        <translation>Oublier ceux-ci</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinceau</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>&amp;Opposite brush</source>
        <translation>Pinceau &amp;opposé</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>&amp;Smaller brush</source>
        <translation>P&amp;inceau plus petit</translation>
    </message>
    <message>
        <source>[</source>
        <translation>[</translation>
    </message>
    <message>
        <source>&amp;Larger brush</source>
        <translation>Pinceau plus &amp;grand</translation>
    </message>
    <message>
        <source>]</source>
        <translation>]</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>&amp;Copier l&apos;image</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>Rég&amp;lages…</translation>
    </message>
    <message>
        <source>&amp;Window/level</source>
        <translation>F&amp;enêtrage</translation>
    </message>
    <message>
        <source>Of the data</source>
        <translation>Des données</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>CT %1  (%2 / %3)</source>
        <translation>TDM %1  (%2 / %3)</translation>
    </message>
    <message>
        <source>By &amp;number…</source>
        <translation>&amp;Par valeurs…</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>&amp;Inverser</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Distance</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>&amp;Angle</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>&amp;Ellipse</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>&amp;Rectangle</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Delete all</source>
        <translation>Tout supprimer</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Mesures</translation>
    </message>
    <message>
        <source>&amp;Show measures</source>
        <translation>Afficher &amp;les mesures</translation>
    </message>
    <message>
        <source>F&amp;ocus</source>
        <translation>&amp;Cible</translation>
    </message>
    <message>
        <source>&amp;No focus</source>
        <translation>&amp;Aucune cible</translation>
    </message>
    <message>
        <source>Ctrl+Backspace</source>
        <translation>Ctrl+Backspace</translation>
    </message>
    <message>
        <source>&amp;Click chooses the focus</source>
        <translation>&amp;Le clic choisit la cible</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>&amp;Lower tolerance</source>
        <translation>&amp;Réduire la tolérance</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>&amp;Higher tolerance</source>
        <translation>Augmenter la &amp;tolérance</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>V&amp;erify this picture…</source>
        <translation>&amp;Vérifier cette image…</translation>
    </message>
    <message>
        <source>Computes pixels drawn at random again, in double precision, and states how exact the picture is</source>
        <translation>Recalcule en double précision des pixels tirés au hasard et indique l&apos;exactitude de l&apos;image</translation>
    </message>
    <message>
        <source>All &amp;views</source>
        <translation>&amp;Toutes les vues</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Plein écran</translation>
    </message>
    <message>
        <source>F11</source>
        <translation>F11</translation>
    </message>
    <message>
        <source>Reset la&amp;yout</source>
        <translation>&amp;Réinitialiser la disposition</translation>
    </message>
    <message>
        <source>Li&amp;ght theme</source>
        <translation>Thème &amp;clair</translation>
    </message>
    <message>
        <source>Anterior</source>
        <translation>Antérieure</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Postérieure</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Superior</source>
        <translation>Supérieure</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>Inférieure</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>Regarder &amp;depuis</translation>
    </message>
    <message>
        <source>Place cameras</source>
        <translation>Placer les caméras</translation>
    </message>
    <message>
        <source>F5</source>
        <translation>F5</translation>
    </message>
    <message>
        <source>&amp;Reset view</source>
        <translation>Ré&amp;initialiser la vue</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Reset &amp;all views</source>
        <translation>Réi&amp;nitialiser toutes les vues</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Link the 3-D views</source>
        <translation>Lier les vues 3D</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>&amp;Parallel projection</source>
        <translation>Pr&amp;ojection parallèle</translation>
    </message>
    <message>
        <source>Ctrl+P</source>
        <translation>Ctrl+P</translation>
    </message>
    <message>
        <source>Animate the cameras</source>
        <translation>Animer les caméras</translation>
    </message>
    <message>
        <source>&amp;Freeze the opening</source>
        <translation>&amp;Figer l&apos;ouverture</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Figer</translation>
    </message>
    <message>
        <source>Keeps the opening where it is while the cameras move, so that they look into it (%1)</source>
        <translation>Laisse l&apos;ouverture en place pendant que les caméras bougent, pour regarder à l&apos;intérieur (%1)</translation>
    </message>
    <message>
        <source>&amp;Crosshair</source>
        <translation>Rétic&amp;ule</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Label &amp;overlay</source>
        <translation>&amp;Superposition des étiquettes</translation>
    </message>
    <message>
        <source>O</source>
        <translation>O</translation>
    </message>
    <message>
        <source>Corner &amp;text</source>
        <translation>Te&amp;xtes des coins</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>&amp;Hide the patient</source>
        <translation>&amp;Masquer le patient</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>&amp;Quality at rest</source>
        <translation>&amp;Qualité au repos</translation>
    </message>
    <message>
        <source>Bound on the error that sampling leaves in a pixel&apos;s colour</source>
        <translation>Borne de l&apos;erreur que l&apos;échantillonnage laisse dans la couleur d&apos;un pixel</translation>
    </message>
    <message>
        <source>&amp;Slices</source>
        <translation>Coupes</translation>
    </message>
    <message>
        <source>Face C&amp;1</source>
        <translation>Face à C&amp;1</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>Face C&amp;2</source>
        <translation>Face à C&amp;2</translation>
    </message>
    <message>
        <source>&amp;Slab</source>
        <translation>&amp;Bloc</translation>
    </message>
    <message>
        <source>&amp;Outlines in 3-D</source>
        <translation>Contours &amp;en 3D</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>&amp;Reset the plane</source>
        <translation>Ré&amp;initialiser le plan</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Reset &amp;all planes</source>
        <translation>Réi&amp;nitialiser tous les plans</translation>
    </message>
    <message>
        <source>Shift+N</source>
        <translation>Shift+N</translation>
    </message>
    <message>
        <source>&amp;Next series</source>
        <translation>Sér&amp;ie suivante</translation>
    </message>
    <message>
        <source>Ctrl+PgDown</source>
        <translation>Ctrl+PgDown</translation>
    </message>
    <message>
        <source>Pre&amp;vious series</source>
        <translation>Série &amp;précédente</translation>
    </message>
    <message>
        <source>Ctrl+PgUp</source>
        <translation>Ctrl+PgUp</translation>
    </message>
    <message>
        <source>&amp;Close study</source>
        <translation>Fer&amp;mer l&apos;examen</translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation>Ctrl+W</translation>
    </message>
    <message>
        <source>Layo&amp;ut of the views</source>
        <translation>Disposition des vues</translation>
    </message>
    <message>
        <source>&amp;One view, the active one</source>
        <translation>&amp;Une vue, celle active</translation>
    </message>
    <message>
        <source>&amp;Next view</source>
        <translation>Vue suivante</translation>
    </message>
    <message>
        <source>Previous view</source>
        <translation>Vue précédente</translation>
    </message>
    <message>
        <source>&amp;Keep this layout…</source>
        <translation>&amp;Garder cette disposition…</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Oublier</translation>
    </message>
    <message>
        <source>Keep this layout</source>
        <translation>Garder cette disposition</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Flip &amp;left and right</source>
        <translation>&amp;Retourner gauche et droite</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Flip &amp;up and down</source>
        <translation>Retourner &amp;haut et bas</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>&amp;Turn by 90°</source>
        <translation>&amp;Tourner de 90°</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Tru&amp;e size</source>
        <translation>T&amp;aille réelle</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>This screen does not say how large it is, so that true size cannot be shown.</source>
        <translation>Cet écran n&apos;indique pas sa taille&#xa0;: la taille réelle ne peut pas être affichée.</translation>
    </message>
    <message>
        <source>&amp;Neurological convention</source>
        <translation>&amp;Convention neurologique</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message numerus="yes">
        <source>%n slices a second</source>
        <translation>
            <numerusform>%n coupe par seconde</numerusform>
            <numerusform>%n coupes par seconde</numerusform>
        </translation>
    </message>
    <message>
        <source>Play &amp;faster</source>
        <translation>&amp;Plus vite</translation>
    </message>
    <message>
        <source>Shift+K</source>
        <translation>Shift+K</translation>
    </message>
    <message>
        <source>Play slo&amp;wer</source>
        <translation>&amp;Moins vite</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>Change &amp;keys…</source>
        <translation>Changer les touches…</translation>
    </message>
    <message>
        <source>%1  (%2 % to %3 % of the values)</source>
        <translation>%1  (%2 % à %3 % des valeurs)</translation>
    </message>
    <message>
        <source>SUV 0 to %1</source>
        <translation>SUV 0 à %1</translation>
    </message>
    <message>
        <source>&amp;My windows</source>
        <translation>&amp;Mes fenêtres</translation>
    </message>
    <message>
        <source>&amp;Keep this window…</source>
        <translation>&amp;Garder cette fenêtre…</translation>
    </message>
    <message>
        <source>%1  (%2 / %3)</source>
        <translation>%1  (%2 / %3)</translation>
    </message>
    <message>
        <source>Keep this window</source>
        <translation>Garder cette fenêtre</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Cerveau</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Mediastinum</source>
        <translation>Médiastin</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Os</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Poumon</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>AVC</translation>
    </message>
    <message>
        <source>Subdural</source>
        <translation>Sous-dural</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Foie</translation>
    </message>
    <message>
        <source>Temporal bone</source>
        <translation>Rocher</translation>
    </message>
    <message>
        <source>Spine, soft tissue</source>
        <translation>Rachis, parties molles</translation>
    </message>
    <message>
        <source>Spine, bone</source>
        <translation>Rachis, os</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>Habituel</translation>
    </message>
    <message>
        <source>All but outliers</source>
        <translation>Tout sauf extrêmes</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Contraste élevé</translation>
    </message>
    <message>
        <source>Bright structures</source>
        <translation>Structures claires</translation>
    </message>
    <message>
        <source>Send to archive…</source>
        <translation>Envoyer à l’archive…</translation>
    </message>
    <message>
        <source>The open series and its labels, to a server of the panel Archive</source>
        <translation>La série ouverte et ses étiquettes, vers un serveur du panneau Archive</translation>
    </message>
    <message>
        <source>They are kept in</source>
        <translation>Ils sont conservés dans</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>Shift+V</source>
        <translation>Shift+V</translation>
    </message>
    <message>
        <source>Keep a key image</source>
        <translation>Garder une image clé</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Save res&amp;ults…</source>
        <translation>Enregistrer les résultats…</translation>
    </message>
    <message>
        <source>Measures, segmentations, pictures and key images as DICOM objects, to a folder or an archive</source>
        <translation>Mesures, segmentations, images et images clés comme objets DICOM, dans un dossier ou une archive</translation>
    </message>
    <message>
        <source>Arro&amp;w</source>
        <translation>&amp;Flèche</translation>
    </message>
    <message>
        <source>&amp;Text</source>
        <translation>&amp;Texte</translation>
    </message>
    <message>
        <source>Change te&amp;xt…</source>
        <translation>Changer le te&amp;xte…</translation>
    </message>
    <message>
        <source>Draw a &amp;path</source>
        <translation>Tracer un tra&amp;jet</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Path along the &amp;focus</source>
        <translation>Trajet le l&amp;ong de la cible</translation>
    </message>
    <message>
        <source>Open besi&amp;de</source>
        <translation>Ouvrir à &amp;côté</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Dossier…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>F&amp;ile…</source>
        <translation>F&amp;ichier…</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>T&amp;wo studies</source>
        <translation>D&amp;eux examens</translation>
    </message>
    <message>
        <source>&amp;Link by patient position</source>
        <translation>&amp;Lier par la position du patient</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>&amp;Match points</source>
        <translation>&amp;Apparier les points</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>&amp;Forget the pair of points</source>
        <translation>&amp;Oublier la paire de points</translation>
    </message>
    <message>
        <source>&amp;Other study</source>
        <translation>A&amp;utre examen</translation>
    </message>
    <message>
        <source>F6</source>
        <translation>F6</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>Pa&amp;nneaux</translation>
    </message>
    <message>
        <source>F9</source>
        <translation>F9</translation>
    </message>
    <message>
        <source>De-identify…</source>
        <translation>Dé-identifier…</translation>
    </message>
    <message>
        <source>Copies of the open series without what names the patient</source>
        <translation>Copies de la série ouverte sans ce qui nomme le patient</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::AppearancePanel</name>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lumière</translation>
    </message>
    <message>
        <source>Ready-made light: how surfaces give it back, from wherever it comes</source>
        <translation>Lumière toute prête&#xa0;: comment les surfaces la renvoient, d&apos;où qu&apos;elle vienne</translation>
    </message>
    <message>
        <source>own</source>
        <translation>personnalisé</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArchiveDock</name>
    <message>
        <source>Archive</source>
        <translation>Archive</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArchiveModel</name>
    <message>
        <source>Patient %1</source>
        <translation>Patient %1</translation>
    </message>
    <message>
        <source>No name</source>
        <translation>Sans nom</translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation>Examen %1</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Série %1</translation>
    </message>
    <message>
        <source>Born %1</source>
        <translation>Né(e) %1</translation>
    </message>
    <message>
        <source>Sex %1</source>
        <translation>Sexe %1</translation>
    </message>
    <message>
        <source>Accession number %1</source>
        <translation>Numéro d&apos;accession %1</translation>
    </message>
    <message>
        <source>Study ID %1</source>
        <translation>ID de l&apos;examen %1</translation>
    </message>
    <message>
        <source>Part of the body: %1</source>
        <translation>Partie du corps&#xa0;: %1</translation>
    </message>
    <message>
        <source>Protocol: %1</source>
        <translation>Protocole&#xa0;: %1</translation>
    </message>
    <message>
        <source>Patient, study</source>
        <translation>Patient, examen</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Images</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArchivePanel</name>
    <message>
        <source>No server is entered, so nothing goes over the network. Add the archive server (PACS) that holds your studies; its administrator knows what to enter.</source>
        <translation>Aucun serveur n&apos;est enregistré&#xa0;: rien ne passe par le réseau. Ajoutez le serveur d&apos;archives (PACS) qui a vos examens&#xa0;; son administrateur sait ce qu&apos;il faut saisir.</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Recherche…</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>The archive server that is asked</source>
        <translation>Le serveur d&apos;archives interrogé</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Tester</translation>
    </message>
    <message>
        <source>Asks the server whether it answers (echo), and says what is wrong</source>
        <translation>Demande au serveur s&apos;il répond (écho), et dit ce qui ne va pas</translation>
    </message>
    <message>
        <source>Servers</source>
        <translation>Serveurs</translation>
    </message>
    <message>
        <source>Add, edit and remove servers</source>
        <translation>Ajouter, modifier et supprimer des serveurs</translation>
    </message>
    <message>
        <source>Add a server…</source>
        <translation>Ajouter un serveur…</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Modifier…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Remove the server</source>
        <translation>Supprimer le serveur</translation>
    </message>
    <message>
        <source>Remove %1?</source>
        <translation>Supprimer %1&#xa0;?</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Retrieves the study or series, and opens it once it is whole (double-click, or drag onto a view)</source>
        <translation>Récupère l&apos;examen ou la série, et l&apos;ouvre dès qu&apos;elle est complète (double clic, ou glisser sur une vue)</translation>
    </message>
    <message>
        <source>Retrieve</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>Fetches what is selected into the cache, to be opened later</source>
        <translation>Met la sélection dans le cache, pour l&apos;ouvrir plus tard</translation>
    </message>
    <message>
        <source>More…</source>
        <translation>Plus…</translation>
    </message>
    <message>
        <source>Asks for more of the studies that match</source>
        <translation>Demande la suite des examens qui correspondent</translation>
    </message>
    <message>
        <source>Asking %1…</source>
        <translation>Interrogation de %1…</translation>
    </message>
    <message>
        <source>%1 answers, in %2 ms.</source>
        <translation>%1 répond, en %2 ms.</translation>
    </message>
    <message>
        <source>Nothing matches. Check the spelling; an asterisk stands for any text, as in *jane*.</source>
        <translation>Rien ne correspond. Vérifiez l&apos;orthographe&#xa0;; un astérisque vaut pour tout texte, comme dans *jane*.</translation>
    </message>
    <message>
        <source>Studies: %1, of patients: %2.</source>
        <translation>Examens&#xa0;: %1, de patients&#xa0;: %2.</translation>
    </message>
    <message>
        <source>There are more: narrow the search, or ask for more.</source>
        <translation>Il y en a d&apos;autres&#xa0;: restreignez la recherche, ou demandez la suite.</translation>
    </message>
    <message>
        <source>The server does not match by some of the fields.</source>
        <translation>Le serveur ne cherche pas par certains des champs.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArrivalView</name>
    <message>
        <source>Looks through the slices that have come</source>
        <translation>Parcourt les coupes déjà arrivées</translation>
    </message>
    <message>
        <source>Slice of those that have come</source>
        <translation>Coupe parmi celles déjà arrivées</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Masquer</translation>
    </message>
    <message>
        <source>Shows the views again; the retrieval goes on</source>
        <translation>Affiche de nouveau les vues ; la récupération continue</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Stops the retrieval; what came is kept</source>
        <translation>Arrête la récupération ; ce qui est arrivé est conservé</translation>
    </message>
    <message>
        <source>Not whole: %1 of %2 images of this series are here. The study opens, with its 3-D views, once all are.</source>
        <translation>Incomplet : %1 images sur %2 de cette série sont arrivées. L’examen s’ouvre, avec ses vues 3D, dès qu’elles y sont toutes.</translation>
    </message>
    <message>
        <source>All images are here. The study is being opened.</source>
        <translation>Toutes les images sont là. L’examen est en cours d’ouverture.</translation>
    </message>
    <message>
        <source>Not whole: frame %1 of %2 is here. The study opens, with its 3-D views, once all are.</source>
        <translation>Incomplet : l’image %1 sur %2 est arrivée. L’examen s’ouvre, avec ses vues 3D, dès qu’elles y sont toutes.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::BestViews</name>
    <message>
        <source>One of the best viewpoints; click to look from there with C1</source>
        <translation>L&apos;un des meilleurs points de vue&#xa0;; cliquer pour regarder de là avec C1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Brush</name>
    <message>
        <source>Nothing is open: choose a focus first</source>
        <translation>Rien n&apos;est ouvert&#xa0;: choisir d&apos;abord une cible</translation>
    </message>
    <message>
        <source>The opening is switched off</source>
        <translation>L&apos;ouverture est désactivée</translation>
    </message>
    <message>
        <source>This method cuts nothing away</source>
        <translation>Cette méthode n&apos;enlève rien</translation>
    </message>
    <message>
        <source>Nothing is there</source>
        <translation>Il n&apos;y a rien ici</translation>
    </message>
    <message>
        <source>Nothing was removed here</source>
        <translation>Rien n&apos;a été enlevé ici</translation>
    </message>
    <message>
        <source>The brush may not cover the focus</source>
        <translation>Le pinceau ne doit pas couvrir la cible</translation>
    </message>
    <message>
        <source>Open down to the focus already</source>
        <translation>Déjà ouvert jusqu&apos;à la cible</translation>
    </message>
    <message>
        <source>The context&apos;s edges are switched off</source>
        <translation>Les arêtes du contexte sont désactivées</translation>
    </message>
    <message>
        <source>Edges are drawn over the focus alone</source>
        <translation>Les arêtes ne sont dessinées que sur la cible</translation>
    </message>
    <message>
        <source>switch the opening on</source>
        <translation>activer l&apos;ouverture</translation>
    </message>
    <message>
        <source>open instead</source>
        <translation>ouvrir plutôt</translation>
    </message>
    <message>
        <source>let it cover the focus</source>
        <translation>le laisser couvrir la cible</translation>
    </message>
    <message>
        <source>restore instead</source>
        <translation>restaurer plutôt</translation>
    </message>
    <message>
        <source>switch the edges on</source>
        <translation>activer les arêtes</translation>
    </message>
    <message>
        <source>take the adaptive cutaway</source>
        <translation>prendre l&apos;écorché adaptatif</translation>
    </message>
    <message>
        <source>Open the context</source>
        <translation>Ouvrir le contexte</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Context&apos;s edges</source>
        <translation>Arêtes du contexte</translation>
    </message>
    <message>
        <source>Brush: %1</source>
        <translation>Pinceau&#xa0;: %1</translation>
    </message>
    <message>
        <source>Space: %1</source>
        <translation>Espace&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %L2 mm</translation>
    </message>
    <message>
        <source>%1 to the surface</source>
        <translation>%1 jusqu&apos;à la surface</translation>
    </message>
    <message>
        <source>%1 %2 %</source>
        <translation>%1 %2 %</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::BrushPanel</name>
    <message>
        <source>Restore to the surface</source>
        <translation>Restaurer jusqu&apos;à la surface</translation>
    </message>
    <message>
        <source>May cover the focus</source>
        <translation>Peut couvrir la cible</translation>
    </message>
    <message>
        <source>In the painted view only</source>
        <translation>Seulement dans la vue peinte</translation>
    </message>
    <message>
        <source>Paint in the 3-D views</source>
        <translation>Peindre dans les vues 3D</translation>
    </message>
    <message>
        <source>The left button paints; Ctrl+left drag still turns the view (P; E for the opposite brush)</source>
        <translation>Le bouton gauche peint&#xa0;; Ctrl+glisser tourne toujours la vue (P&#xa0;; E pour le pinceau opposé)</translation>
    </message>
    <message>
        <source>Restore brings back all that was removed under the brush; otherwise no more than the depth</source>
        <translation>Restaurer ramène tout ce qui a été enlevé sous le pinceau&#xa0;; sinon pas plus que la profondeur</translation>
    </message>
    <message>
        <source>Otherwise restored tissue never hides the focus</source>
        <translation>Sinon, le tissu restauré ne cache jamais la cible</translation>
    </message>
    <message>
        <source>Otherwise a stroke shows in both views</source>
        <translation>Sinon, un trait apparaît dans les deux vues</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Douceur</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Quantité</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CacheRow</name>
    <message>
        <source>Move…</source>
        <translation>Déplacer…</translation>
    </message>
    <message>
        <source>Chooses where objects are kept from now on; those of before stay where they are</source>
        <translation>Choisit où les objets sont conservés désormais&#xa0;; les précédents restent où ils sont</translation>
    </message>
    <message>
        <source>Keep objects of archives in</source>
        <translation>Conserver les objets des archives dans</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vider</translation>
    </message>
    <message>
        <source>Removes all objects that were retrieved; not while some come in</source>
        <translation>Supprime tous les objets récupérés&#xa0;; pas pendant que d&apos;autres arrivent</translation>
    </message>
    <message>
        <source>Remove all objects that were retrieved? The servers still have them, but sessions that refer to them find their data no more.</source>
        <translation>Supprimer tous les objets récupérés&#xa0;? Les serveurs les ont encore, mais les sessions qui s&apos;y réfèrent ne trouveront plus leurs données.</translation>
    </message>
    <message>
        <source>Clears…</source>
        <translation>Vidage…</translation>
    </message>
    <message>
        <source>Counts…</source>
        <translation>Comptage…</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 dans %2</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CamerasPanel</name>
    <message>
        <source>Place cameras</source>
        <translation>Placer les caméras</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Look for the best view of the focus and the one that complements it (F5)</source>
        <translation>Cherche la meilleure vue de la cible et celle qui la complète (F5)</translation>
    </message>
    <message>
        <source>The two views see &lt;b&gt;%1 %&lt;/b&gt; of the focus&apos;s surface</source>
        <translation>Les deux vues voient &lt;b&gt;%1 %&lt;/b&gt; de la surface de la cible</translation>
    </message>
    <message>
        <source>Needs the 3-D views</source>
        <translation>Nécessite les vues 3D</translation>
    </message>
    <message>
        <source>Looking at the focus from all sides…</source>
        <translation>Examen de la cible de tous les côtés…</translation>
    </message>
    <message>
        <source>Click a structure on a slice</source>
        <translation>Cliquer une structure sur une coupe</translation>
    </message>
    <message>
        <source>Not placed yet for this focus</source>
        <translation>Pas encore placées pour cette cible</translation>
    </message>
    <message>
        <source>Choose a focus first</source>
        <translation>Choisir d&apos;abord une cible</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Carving</name>
    <message>
        <source>Carve: %1</source>
        <translation>Sculpter&#xa0;: %1</translation>
    </message>
    <message>
        <source>Bend the plane</source>
        <translation>Courber le plan</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CarvingRows</name>
    <message>
        <source>Restore all</source>
        <translation>Tout restaurer</translation>
    </message>
    <message>
        <source>Carve</source>
        <translation>Sculpter</translation>
    </message>
    <message>
        <source>The left button carves in all views when it is let go; Ctrl+left drag still turns the view</source>
        <translation>Le bouton gauche sculpte dans toutes les vues au relâchement&#xa0;; Ctrl+glisser tourne toujours la vue</translation>
    </message>
    <message>
        <source>Brings back all that was carved away</source>
        <translation>Ramène tout ce qui a été sculpté</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ClippingPanel</name>
    <message>
        <source>Crop to a box</source>
        <translation>Rogner à une boîte</translation>
    </message>
    <message>
        <source>Add a plane</source>
        <translation>Ajouter un plan</translation>
    </message>
    <message>
        <source>Cut everything off behind a plane; up to three</source>
        <translation>Coupe tout ce qui est derrière un plan&#xa0;; trois au plus</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Retourner</translation>
    </message>
    <message>
        <source>Keep the other side of the plane</source>
        <translation>Garder l&apos;autre côté du plan</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Enlever</translation>
    </message>
    <message>
        <source>Remove the plane</source>
        <translation>Enlever le plan</translation>
    </message>
    <message>
        <source>Clip nothing</source>
        <translation>Ne rien découper</translation>
    </message>
    <message>
        <source>Switch off the box, and remove all planes</source>
        <translation>Désactiver la boîte et enlever tous les plans</translation>
    </message>
    <message>
        <source>R – L</source>
        <translation>R – L</translation>
    </message>
    <message>
        <source>A – P</source>
        <translation>A – P</translation>
    </message>
    <message>
        <source>I – S</source>
        <translation>I – S</translation>
    </message>
    <message>
        <source>The patient&apos;s right end of the box</source>
        <translation>Côté droit de la boîte (celui du patient)</translation>
    </message>
    <message>
        <source>The patient&apos;s left end of the box</source>
        <translation>Côté gauche de la boîte (celui du patient)</translation>
    </message>
    <message>
        <source>The front end of the box</source>
        <translation>Face avant de la boîte</translation>
    </message>
    <message>
        <source>The back end of the box</source>
        <translation>Face arrière de la boîte</translation>
    </message>
    <message>
        <source>The lower end of the box</source>
        <translation>Face inférieure de la boîte</translation>
    </message>
    <message>
        <source>The upper end of the box</source>
        <translation>Face supérieure de la boîte</translation>
    </message>
    <message>
        <source>Drag a plane&apos;s square to move it, and the ball at its arrow to tilt it, in any view</source>
        <translation>Glisser le carré d&apos;un plan pour le déplacer et la boule de sa flèche pour l&apos;incliner, dans n&apos;importe quelle vue</translation>
    </message>
    <message>
        <source>Where the plane lies along its arrow</source>
        <translation>Position du plan le long de sa flèche</translation>
    </message>
    <message>
        <source>From the axial slice</source>
        <translation>De la coupe axiale</translation>
    </message>
    <message>
        <source>From the sagittal slice</source>
        <translation>De la coupe sagittale</translation>
    </message>
    <message>
        <source>From the coronal slice</source>
        <translation>De la coupe coronale</translation>
    </message>
    <message>
        <source>Facing camera C1</source>
        <translation>Face à la caméra C1</translation>
    </message>
    <message>
        <source>3-D pictures show only the inside of a box along the volume&apos;s axes</source>
        <translation>Les images 3D ne montrent que l&apos;intérieur d&apos;une boîte selon les axes du volume</translation>
    </message>
    <message>
        <source>As the transfer function</source>
        <translation>Comme la fonction de transfert</translation>
    </message>
    <message>
        <source>Grey, as the slices</source>
        <translation>Gris, comme les coupes</translation>
    </message>
    <message>
        <source>What the cut faces show. Grey takes the window that the slices have now</source>
        <translation>Ce que montrent les faces de coupe. Gris prend le fenêtrage actuel des coupes</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Cut faces</source>
        <translation>Faces de coupe</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Rogner</translation>
    </message>
    <message>
        <source>Flip the clip plane</source>
        <translation>Retourner le plan de découpe</translation>
    </message>
    <message>
        <source>Remove the clip plane</source>
        <translation>Enlever le plan de découpe</translation>
    </message>
    <message>
        <source>Move the clip plane</source>
        <translation>Déplacer le plan de découpe</translation>
    </message>
    <message>
        <source>Add a clip plane</source>
        <translation>Ajouter un plan de découpe</translation>
    </message>
    <message>
        <source>Plane %1, keeps %2</source>
        <translation>Plan %1, garde %2</translation>
    </message>
    <message>
        <source>Labels that are never clipped are chosen in the list of structures, by their role.</source>
        <translation>Les étiquettes jamais découpées se choisissent dans la liste des structures, par leur rôle.</translation>
    </message>
    <message>
        <source>Structures that are never clipped: %1</source>
        <translation>Structures jamais découpées&#xa0;: %1</translation>
    </message>
    <message>
        <source>Clip planes</source>
        <translation>Plans de découpe</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ContextLayerPanel</name>
    <message>
        <source>Context edges: %1</source>
        <translation>Arêtes du contexte&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CopyRows</name>
    <message>
        <source>Copy the &amp;value</source>
        <translation>Copier la &amp;valeur</translation>
    </message>
    <message>
        <source>&amp;Copy the rows</source>
        <translation>&amp;Copier les lignes</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CutawayPanel</name>
    <message>
        <source>own</source>
        <translation>personnalisé</translation>
    </message>
    <message>
        <source>Ready-made border and context edges</source>
        <translation>Bordure et arêtes du contexte toutes prêtes</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>Smooth edges, by several rays a pixel, are the adaptive cutaway&apos;s alone</source>
        <translation>Les bords lisses, par plusieurs rayons par pixel, sont réservés à l&apos;écorché adaptatif</translation>
    </message>
    <message>
        <source>This method has no width: it cuts nothing away</source>
        <translation>Cette méthode n&apos;a pas de largeur&#xa0;: elle n&apos;enlève rien</translation>
    </message>
    <message>
        <source>This method has no width of its own: the focus and the lens decide on it</source>
        <translation>Cette méthode n&apos;a pas de largeur propre&#xa0;: la cible et la lentille en décident</translation>
    </message>
    <message>
        <source>This method has no width of its own: the focus and the angle decide on it</source>
        <translation>Cette méthode n&apos;a pas de largeur propre&#xa0;: la cible et l&apos;angle en décident</translation>
    </message>
    <message>
        <source>The line of this method is the rim of its lens</source>
        <translation>La ligne de cette méthode est le bord de sa lentille</translation>
    </message>
    <message>
        <source>This method has no line: it cuts nothing away</source>
        <translation>Cette méthode n&apos;a pas de ligne&#xa0;: elle n&apos;enlève rien</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::DeidentifyDialog</name>
    <message>
        <source>removed</source>
        <translation>supprimé</translation>
    </message>
    <message>
        <source>emptied</source>
        <translation>vidé</translation>
    </message>
    <message>
        <source>replaced by a dummy</source>
        <translation>remplacé par une valeur fictive</translation>
    </message>
    <message>
        <source>replaced by a new UID</source>
        <translation>remplacé par un nouvel UID</translation>
    </message>
    <message>
        <source>cleaned</source>
        <translation>nettoyé</translation>
    </message>
    <message>
        <source>De-identify</source>
        <translation>Dé-identifier</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Écriture…</translation>
    </message>
    <message>
        <source>Copies of the open series, images: %1</source>
        <translation>Copies de la série ouverte, images : %1</translation>
    </message>
    <message>
        <source>All labels, as a DICOM segmentation</source>
        <translation>Toutes les étiquettes, en segmentation DICOM</translation>
    </message>
    <message>
        <source>Their names go with the descriptions, unless these are cleaned</source>
        <translation>Leurs noms disparaissent avec les descriptions, sauf si celles-ci sont nettoyées</translation>
    </message>
    <message>
        <source>Keep dates and times</source>
        <translation>Garder les dates et heures</translation>
    </message>
    <message>
        <source>As they are; with them a patient may be found</source>
        <translation>Telles quelles ; elles peuvent permettre de retrouver un patient</translation>
    </message>
    <message>
        <source>Keep UIDs</source>
        <translation>Garder les UID</translation>
    </message>
    <message>
        <source>As they are; whoever has the originals can tell which is which</source>
        <translation>Tels quels ; qui possède les originaux peut faire le lien</translation>
    </message>
    <message>
        <source>Clean descriptions</source>
        <translation>Nettoyer les descriptions</translation>
    </message>
    <message>
        <source>Of descriptions, the words stay that say nothing about a person; otherwise they go</source>
        <translation>Des descriptions restent les mots qui ne disent rien d’une personne ; sinon elles disparaissent</translation>
    </message>
    <message>
        <source>Clean graphics</source>
        <translation>Nettoyer les graphiques</translation>
    </message>
    <message>
        <source>The shapes of annotations stay; overlays and curves go in any case</source>
        <translation>Les formes des annotations restent ; les surimpressions et courbes disparaissent toujours</translation>
    </message>
    <message>
        <source>Remove the face, from a head in CT or MR</source>
        <translation>Supprimer le visage d’une tête en CT ou IRM</translation>
    </message>
    <message>
        <source>All in front of a plane from the brow to the chin is blanked. Look at the copies, as slices and in 3-D: a nodded or turned head may keep a part of its face, or lose some brain</source>
        <translation>Tout ce qui est devant un plan allant du sourcil au menton est effacé. Regardez les copies, en coupes et en 3D : une tête penchée ou tournée peut garder une partie du visage ou perdre un peu de cerveau</translation>
    </message>
    <message>
        <source>Look at the copies before you give them away: no program finds a name that is written into a picture, or knows whether all of a face is gone.</source>
        <translation>Regardez les copies avant de les donner : aucun programme ne trouve un nom écrit dans l’image ni ne sait si un visage a entièrement disparu.</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>Ce qui change</translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation>Attribut</translation>
    </message>
    <message>
        <source>Becomes</source>
        <translation>Devient</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>To a new folder in</source>
        <translation>Dans un nouveau dossier de</translation>
    </message>
    <message>
        <source>A folder named de-identified is made there</source>
        <translation>Un dossier nommé de-identified y est créé</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>To the archive</source>
        <translation>Vers l&apos;archive</translation>
    </message>
    <message>
        <source>The server answers for each object</source>
        <translation>Le serveur répond pour chaque objet</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Serveur</translation>
    </message>
    <message>
        <source>Keep a map in the file</source>
        <translation>Garder une table dans le fichier</translation>
    </message>
    <message>
        <source>Old and new UIDs and patients&apos; numbers, readable by you alone. Without it nobody can tell which was which</source>
        <translation>Anciens et nouveaux UID et numéros de patient, lisibles par vous seul. Sans elle, personne ne peut faire le lien</translation>
    </message>
    <message>
        <source>File of the map</source>
        <translation>Fichier de la table</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Folder of the copies</source>
        <translation>Dossier des copies</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tableaux</translation>
    </message>
    <message>
        <source>%1 copies are in %2.</source>
        <translation>%1 copies sont dans %2.</translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation>Copie %1</translation>
    </message>
    <message>
        <source>Copies without the face: %1. Look at each of them.</source>
        <translation>Copies sans le visage : %1. Regardez chacune.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::DockFolding</name>
    <message>
        <source>Fold %1</source>
        <translation>Replier %1</translation>
    </message>
    <message>
        <source>Folds this panel to its title, so that others have more room</source>
        <translation>Replie ce panneau sur son titre, pour laisser plus de place aux autres</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Document</name>
    <message>
        <source>%1×%2×%3 · %4×%5×%6 mm</source>
        <translation>%1×%2×%3 · %L4×%L5×%L6 mm</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rôle</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Fonction de transfert</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Never clipped</source>
        <translation>Jamais découpée</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Région</translation>
    </message>
    <message>
        <source>Size of the region</source>
        <translation>Taille de la région</translation>
    </message>
    <message>
        <source>Add to the region</source>
        <translation>Ajouter à la région</translation>
    </message>
    <message>
        <source>Take away from the region</source>
        <translation>Retirer de la région</translation>
    </message>
    <message>
        <source>Paint the region</source>
        <translation>Peindre la région</translation>
    </message>
    <message>
        <source>Erase from the region</source>
        <translation>Effacer de la région</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>The focus before still shows, until you open to the region</source>
        <translation>La cible précédente reste affichée jusqu&apos;à l&apos;ouverture vers la région</translation>
    </message>
    <message>
        <source>Growing the region; the focus before still shows</source>
        <translation>La région croît&#xa0;; la cible précédente reste affichée</translation>
    </message>
    <message>
        <source>Growing the region; this is a first part</source>
        <translation>La région croît&#xa0;; en voici une première partie</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Exports</name>
    <message>
        <source>NRRD, with names and colours</source>
        <translation>NRRD, avec noms et couleurs</translation>
    </message>
    <message>
        <source>DICOM segmentation, with names and colours</source>
        <translation>Segmentation DICOM, avec noms et couleurs</translation>
    </message>
    <message>
        <source>NIfTI</source>
        <translation>NIfTI</translation>
    </message>
    <message>
        <source>MetaImage</source>
        <translation>MetaImage</translation>
    </message>
    <message>
        <source>Export all labels</source>
        <translation>Exporter toutes les étiquettes</translation>
    </message>
    <message>
        <source>Export the focus as labels</source>
        <translation>Exporter la cible en étiquettes</translation>
    </message>
    <message>
        <source>%1 in mm, %2 axes</source>
        <translation>%1 en mm, axes %2</translation>
    </message>
    <message>
        <source>Export the focus as a surface</source>
        <translation>Exporter la cible en surface</translation>
    </message>
    <message>
        <source>Table (CSV)</source>
        <translation>Tableau (CSV)</translation>
    </message>
    <message>
        <source>Export the measures</source>
        <translation>Exporter les mesures</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Région</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 écrit</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::FileOpener</name>
    <message>
        <source>Open as volume</source>
        <translation>Ouvrir comme volume</translation>
    </message>
    <message>
        <source>Open as labels of this volume</source>
        <translation>Ouvrir comme étiquettes de ce volume</translation>
    </message>
    <message>
        <source>Volumes (*.dcm %1);;All files (*)</source>
        <translation>Volumes (*.dcm %1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Open a volume</source>
        <translation>Ouvrir un volume</translation>
    </message>
    <message>
        <source>Open a DICOM folder</source>
        <translation>Ouvrir un dossier DICOM</translation>
    </message>
    <message>
        <source>Label maps (*.dcm %1);;All files (*)</source>
        <translation>Cartes d&apos;étiquettes (*.dcm %1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Open a label map</source>
        <translation>Ouvrir une carte d&apos;étiquettes</translation>
    </message>
    <message>
        <source>Open a folder of masks</source>
        <translation>Ouvrir un dossier de masques</translation>
    </message>
    <message>
        <source>Tables of labels (*.txt *.tsv *.csv *.label *.ctbl *.lut);;All files (*)</source>
        <translation>Tables d&apos;étiquettes (*.txt *.tsv *.csv *.label *.ctbl *.lut);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Open a table of labels</source>
        <translation>Ouvrir une table d&apos;étiquettes</translation>
    </message>
    <message>
        <source>How large the voxels are:</source>
        <translation>Taille des voxels&#xa0;:</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::FocusPanel</name>
    <message>
        <source>No labels. Click a structure in a picture, open a label map (Ctrl+L), or choose a range of values below.</source>
        <translation>Aucune étiquette. Cliquez une structure dans une image, ouvrez une carte d&apos;étiquettes (Ctrl+L) ou choisissez une plage de valeurs ci-dessous.</translation>
    </message>
    <message>
        <source>Focus on values</source>
        <translation>Cible par valeurs</translation>
    </message>
    <message>
        <source>Find a structure</source>
        <translation>Chercher une structure</translation>
    </message>
    <message>
        <source>The focus is everything whose value lies in this range</source>
        <translation>La cible est tout ce dont la valeur est dans cette plage</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>Without islands below</source>
        <translation>Sans îlots sous</translation>
    </message>
    <message>
        <source>Paint the region</source>
        <translation>Peindre la région</translation>
    </message>
    <message>
        <source>The left button paints the region in focus in all views; with Shift it erases</source>
        <translation>Le bouton gauche peint la région ciblée dans toutes les vues&#xa0;; avec Maj il efface</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Douceur</translation>
    </message>
    <message>
        <source>Nothing open</source>
        <translation>Rien d&apos;ouvert</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::GuideWindow</name>
    <message>
        <source>Not on this page</source>
        <translation>Absent de cette page</translation>
    </message>
    <message>
        <source>User guide of Fenestra</source>
        <translation>Guide de l&apos;utilisateur de Fenestra</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Left</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Alt+Right</source>
        <translation>Alt+Right</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>Shift+F3</source>
        <translation>Shift+F3</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>F3</source>
        <translation>F3</translation>
    </message>
    <message>
        <source>Find on this page</source>
        <translation>Chercher dans cette page</translation>
    </message>
    <message>
        <source>Return goes to the next place (Ctrl+F)</source>
        <translation>Entrée va à l&apos;endroit suivant (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ImportanceList</name>
    <message>
        <source>What hides a label of a higher level is opened for it; what has the same level or a higher one never is. All else has level 0.</source>
        <translation>Ce qui cache une étiquette de niveau supérieur s&apos;ouvre pour elle&#xa0;; ce qui a le même niveau ou un niveau supérieur, jamais. Tout le reste est de niveau 0.</translation>
    </message>
    <message>
        <source>Another label…</source>
        <translation>Autre étiquette…</translation>
    </message>
    <message>
        <source>Gives a label that is not in focus a level of importance</source>
        <translation>Donne un niveau d&apos;importance à une étiquette hors de la cible</translation>
    </message>
    <message>
        <source>Level of importance</source>
        <translation>Niveau d&apos;importance</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeyBindings</name>
    <message>
        <source>It is not JSON, from character %1 on: %2.</source>
        <translation>Ce n&apos;est pas du JSON, à partir du caractère %1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>It does not hold Fenestra&apos;s keys: choose a file that Export in this dialog wrote.</source>
        <translation>Il ne contient pas les touches de Fenestra&#xa0;: choisissez un fichier écrit par Exporter dans ce dialogue.</translation>
    </message>
    <message>
        <source>It was written by a newer version of Fenestra.</source>
        <translation>Il a été écrit par une version plus récente de Fenestra.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, of &quot;%2&quot;, is no key.</source>
        <translation>«&#xa0;%1 », de «&#xa0;%2 », n&apos;est pas une touche.</translation>
    </message>
    <message>
        <source>%1, of &quot;%2&quot;, is a key of the views.</source>
        <translation>%1, de «&#xa0;%2 », est une touche des vues.</translation>
    </message>
    <message>
        <source>%1 is the key of both &quot;%2&quot; and &quot;%3&quot;.</source>
        <translation>%1 est la touche de «&#xa0;%2&#xa0;» et de «&#xa0;%3 ».</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeyImages</name>
    <message>
        <source>Key image %1</source>
        <translation>Image clé&#xa0;%1</translation>
    </message>
    <message>
        <source>Keep a key image</source>
        <translation>Garder une image clé</translation>
    </message>
    <message>
        <source>Return to a key image</source>
        <translation>Revenir à une image clé</translation>
    </message>
    <message>
        <source>Rename a key image</source>
        <translation>Renommer une image clé</translation>
    </message>
    <message>
        <source>Delete a key image</source>
        <translation>Supprimer une image clé</translation>
    </message>
    <message>
        <source>Move a key image</source>
        <translation>Déplacer une image clé</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeyImagesPanel</name>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Garder</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Images clés</translation>
    </message>
    <message>
        <source>Keeps the cameras, slices, crosshair, focus and look as they are now</source>
        <translation>Garde les caméras, les coupes, le réticule, la cible et l&apos;apparence tels qu&apos;ils sont</translation>
    </message>
    <message>
        <source>Moves the key image up</source>
        <translation>Monte l&apos;image clé</translation>
    </message>
    <message>
        <source>Moves the key image down</source>
        <translation>Descend l&apos;image clé</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeysDialog</name>
    <message>
        <source>Change keys</source>
        <translation>Changer les touches</translation>
    </message>
    <message>
        <source>Show entries with these words or keys</source>
        <translation>Afficher les entrées avec ces mots ou touches</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>&amp;Take it</source>
        <translation>&amp;La prendre</translation>
    </message>
    <message>
        <source>Gives the key to this entry, and the other one loses it</source>
        <translation>Donne la touche à cette entrée, et l&apos;autre la perd</translation>
    </message>
    <message>
        <source>&amp;No key</source>
        <translation>&amp;Aucune touche</translation>
    </message>
    <message>
        <source>As it &amp;was</source>
        <translation>&amp;Comme avant</translation>
    </message>
    <message>
        <source>The key that the entry comes with</source>
        <translation>La touche d&apos;origine de l&apos;entrée</translation>
    </message>
    <message>
        <source>&amp;Key</source>
        <translation>&amp;Touche</translation>
    </message>
    <message>
        <source>&amp;All as they were</source>
        <translation>T&amp;outes comme avant</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporter…</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>Click into the box and press the key. Changed keys are bold.</source>
        <translation>Cliquez dans la case et appuyez sur la touche. Les touches changées sont en gras.</translation>
    </message>
    <message>
        <source>%1 is a key of the views: no entry can have it.</source>
        <translation>%1 est une touche des vues&#xa0;: aucune entrée ne peut l&apos;avoir.</translation>
    </message>
    <message>
        <source>%1 is the key of %2 → %3. Take it?</source>
        <translation>%1 est la touche de %2 → %3. La prendre&#xa0;?</translation>
    </message>
    <message>
        <source>Export keys</source>
        <translation>Exporter les touches</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Écrit dans&#xa0;%1.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another folder.</source>
        <translation>%1 ne peut pas être écrit&#xa0;: %2. Choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>Import keys</source>
        <translation>Importer les touches</translation>
    </message>
    <message>
        <source>Keys (*.json);;All files (*)</source>
        <translation>Touches (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 ne peut pas être lu&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Taken over from %1.</source>
        <translation>Repris de %1.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelEditPanel</name>
    <message>
        <source>Grow</source>
        <translation>Dilater</translation>
    </message>
    <message>
        <source>Add what lies within this distance; other labels keep their voxels</source>
        <translation>Ajoute ce qui est à cette distance&#xa0;; les autres étiquettes gardent leurs voxels</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Éroder</translation>
    </message>
    <message>
        <source>Remove what lies within this distance of the outside</source>
        <translation>Enlève ce qui est à cette distance de l&apos;extérieur</translation>
    </message>
    <message>
        <source>Remove islands</source>
        <translation>Enlever les îlots</translation>
    </message>
    <message>
        <source>Remove separate parts smaller than this</source>
        <translation>Enlève les parties isolées plus petites</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Boucher les trous</translation>
    </message>
    <message>
        <source>Add what the label encloses</source>
        <translation>Ajoute ce que l&apos;étiquette enferme</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelEditor</name>
    <message>
        <source>Grow label</source>
        <translation>Dilater l&apos;étiquette</translation>
    </message>
    <message>
        <source>Shrink label</source>
        <translation>Éroder l&apos;étiquette</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Boucher les trous</translation>
    </message>
    <message>
        <source>Remove islands</source>
        <translation>Enlever les îlots</translation>
    </message>
    <message>
        <source>Keep region</source>
        <translation>Conserver la région</translation>
    </message>
    <message>
        <source>All 65535 values that a label may have are in use</source>
        <translation>Les 65535 valeurs possibles d&apos;une étiquette sont utilisées</translation>
    </message>
    <message>
        <source>Nothing would be left of the label</source>
        <translation>Il ne resterait rien de l&apos;étiquette</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelList</name>
    <message>
        <source>No structure&apos;s name has these words.</source>
        <translation>Aucune structure ne porte ces mots.</translation>
    </message>
    <message>
        <source>Show the label</source>
        <translation>Afficher l&apos;étiquette</translation>
    </message>
    <message>
        <source>Do not show the label</source>
        <translation>Ne pas afficher l&apos;étiquette</translation>
    </message>
    <message>
        <source>Colour of the label</source>
        <translation>Couleur de l&apos;étiquette</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>What the view opens to</source>
        <translation>Ce vers quoi la vue s&apos;ouvre</translation>
    </message>
    <message>
        <source>Never clipped</source>
        <translation>Jamais découpée</translation>
    </message>
    <message>
        <source>Stays outside the crop box and behind clip planes, as part of the context</source>
        <translation>Reste hors de la boîte et derrière les plans de découpe, comme partie du contexte</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Couleur…</translation>
    </message>
    <message>
        <source>The label map&apos;s own colour</source>
        <translation>La couleur de la carte d&apos;étiquettes</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Structures</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelModel</name>
    <message>
        <source>Label %1</source>
        <translation>Étiquette&#xa0;%1</translation>
    </message>
    <message>
        <source>Label %1. Tick it to open the view to it; double-click to focus on it alone and go there; F2 renames it.</source>
        <translation>Étiquette&#xa0;%1. La cocher ouvre la vue vers elle&#xa0;; un double clic en fait la seule cible et y va&#xa0;; F2 la renomme.</translation>
    </message>
    <message>
        <source>Click to choose another colour</source>
        <translation>Cliquer pour choisir une autre couleur</translation>
    </message>
    <message>
        <source>Click to show it or not: slices tint what is visible, and 3-D pictures draw it while it is in focus or protected</source>
        <translation>Cliquer pour l&apos;afficher ou non&#xa0;: les coupes teintent ce qui est visible, et les images 3D la dessinent si elle est ciblée ou protégée</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Focus: what the view opens to</source>
        <translation>Cible&#xa0;: ce vers quoi la vue s&apos;ouvre</translation>
    </message>
    <message>
        <source>Opacity of its surface, however thick it is, and of its tint on slices; click to change it. At 0 % it is left out of the 3-D pictures.</source>
        <translation>Opacité de sa surface, quelle que soit son épaisseur, et de sa teinte sur les coupes&#xa0;; cliquer pour la changer. À 0 %, elle est absente des images 3D.</translation>
    </message>
    <message>
        <source>C1 sees %1 of its surface, C2 %2, both together %3: measured where cameras are tried, nearest to these</source>
        <translation>C1 voit %1 de sa surface, C2 %2, les deux ensemble %3&#xa0;: mesuré aux caméras essayées les plus proches</translation>
    </message>
    <message>
        <source>Share of its surface that C1 and C2 see; measured for labels in focus when cameras are placed</source>
        <translation>Part de sa surface que voient C1 et C2&#xa0;; mesurée pour les étiquettes ciblées au placement des caméras</translation>
    </message>
    <message numerus="yes">
        <source>%n label(s) without voxels</source>
        <translation>
            <numerusform>%n étiquette sans voxels</numerusform>
            <numerusform>%n étiquettes sans voxels</numerusform>
        </translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Vu</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelTable</name>
    <message>
        <source>&amp;Copy all (CSV)</source>
        <translation>&amp;Tout copier (CSV)</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Enregistrer…</translation>
    </message>
    <message>
        <source>Label table</source>
        <translation>Tableau des étiquettes</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Mean, %1</source>
        <translation>Moyenne,&#xa0;%1</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>ET</translation>
    </message>
    <message>
        <source>Extent, mm</source>
        <translation>Étendue, mm</translation>
    </message>
    <message>
        <source>Seen, C1</source>
        <translation>Vu, C1</translation>
    </message>
    <message>
        <source>Seen, C2</source>
        <translation>Vu, C2</translation>
    </message>
    <message>
        <source>Sides of its box along the patient: left to right, front to back, foot to head</source>
        <translation>Côtés de sa boîte le long du patient&#xa0;: gauche à droite, avant en arrière, pieds à tête</translation>
    </message>
    <message>
        <source>Share of its surface that the camera sees; measured for labels in focus when cameras are placed</source>
        <translation>Part de sa surface que voit la caméra&#xa0;; mesurée pour les étiquettes ciblées quand les caméras sont placées</translation>
    </message>
    <message>
        <source>Label %1</source>
        <translation>Étiquette&#xa0;%1</translation>
    </message>
    <message>
        <source>This study has no labels. Open some from the File menu, or keep a grown region as a label.</source>
        <translation>Cet examen n&apos;a pas d&apos;étiquettes. Ouvrez-en par le menu Fichier, ou gardez une région comme étiquette.</translation>
    </message>
    <message>
        <source>Measuring the labels…</source>
        <translation>Mesure des étiquettes…</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Save the label table</source>
        <translation>Enregistrer le tableau des étiquettes</translation>
    </message>
    <message>
        <source>Table (CSV)</source>
        <translation>Tableau (CSV)</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Écrit dans&#xa0;%1.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LoadingBar</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::MainWindow</name>
    <message>
        <source>Growing the region</source>
        <translation>Croissance de la région</translation>
    </message>
    <message>
        <source>Editing the label</source>
        <translation>Modification de l&apos;étiquette</translation>
    </message>
    <message>
        <source>Verifying the picture</source>
        <translation>Vérification de l&apos;image</translation>
    </message>
    <message>
        <source>Opening…</source>
        <translation>Ouverture…</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Écriture…</translation>
    </message>
    <message>
        <source>%1 was named at the start and is not open.</source>
        <translation>%1 a été indiqué au démarrage et n&apos;est pas ouvert.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Other data</source>
        <translation>D&apos;autres données</translation>
    </message>
    <message>
        <source>Place cameras</source>
        <translation>Placer les caméras</translation>
    </message>
    <message>
        <source>The region is %1, which is %2 % of the body. The slices show its outline; open the 3-D views to it?</source>
        <translation>La région fait %1, soit %2 % du corps. Les coupes montrent son contour&#xa0;; ouvrir les vues 3D vers elle&#xa0;?</translation>
    </message>
    <message>
        <source>The region, %1, has a doubtful border. The slices show its outline; open the 3-D views to it?</source>
        <translation>La région, de %1, a un bord douteux. Les coupes montrent son contour&#xa0;; ouvrir les vues 3D vers elle&#xa0;?</translation>
    </message>
    <message>
        <source>Open to it</source>
        <translation>Ouvrir vers elle</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>L&apos;annuler</translation>
    </message>
    <message>
        <source>%1 lies over other labels and took %2 from them; undo brings them back.</source>
        <translation>%1 recouvre d&apos;autres étiquettes et leur a pris %2&#xa0;; Annuler les ramène.</translation>
    </message>
    <message>
        <source>There are %1 key images; delete some to keep another.</source>
        <translation>Il y a&#xa0;%1 images clés&#xa0;; supprimez-en pour en garder une autre.</translation>
    </message>
    <message>
        <source>The patient may lie differently in the two studies: linked without a pair of points, the same coordinates may be other places. Unlink, put both crosshairs onto the same point, and choose Match points; the link is as good as that pair.</source>
        <translation>Le patient peut être placé autrement dans les deux examens : sans paire de points, les mêmes coordonnées peuvent être d’autres endroits. Déliez, placez les deux réticules sur le même point et choisissez Apparier les points ; le lien vaut ce que vaut cette paire.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::MeasureMode</name>
    <message>
        <source>Delete measure</source>
        <translation>Supprimer la mesure</translation>
    </message>
    <message>
        <source>Delete all measures</source>
        <translation>Supprimer toutes les mesures</translation>
    </message>
    <message>
        <source>Move measure</source>
        <translation>Déplacer la mesure</translation>
    </message>
    <message>
        <source>Change text</source>
        <translation>Changer le texte</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::NoticeBar</name>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n autre</numerusform>
            <numerusform>%n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Files…</source>
        <translation>Fichiers…</translation>
    </message>
    <message>
        <source>Files concerned</source>
        <translation>Fichiers concernés</translation>
    </message>
    <message>
        <source>Slices scanned: %1, %2 mm apart for the most part
Planes shown: %3, %4 mm apart
Farthest from its place as shown: %5 mm; with the slices spread evenly: %6 mm
Planes in wide gaps: %7
Voxels outside of what was scanned: %8</source>
        <translation>Coupes acquises&#xa0;: %1, espacées le plus souvent de %L2 mm
Plans affichés&#xa0;: %3, espacés de %L4 mm
Plus grand écart à la place réelle, tel qu&apos;affiché&#xa0;: %L5 mm&#xa0;; coupes réparties régulièrement&#xa0;: %L6 mm
Plans dans de larges vides&#xa0;: %7
Voxels hors de ce qui a été acquis&#xa0;: %8</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Geometry report</source>
        <translation>Rapport de géométrie</translation>
    </message>
    <message>
        <source>Load as is</source>
        <translation>Charger tel quel</translation>
    </message>
    <message>
        <source>Regularise</source>
        <translation>Régulariser</translation>
    </message>
    <message>
        <source>Make straight</source>
        <translation>Redresser</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PathCameras</name>
    <message>
        <source>Cameras follow the path</source>
        <translation>Les caméras suivent le trajet</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PathMode</name>
    <message>
        <source>Draw a path</source>
        <translation>Tracer un trajet</translation>
    </message>
    <message>
        <source>Move a point of the path</source>
        <translation>Déplacer un point du trajet</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PathOpening</name>
    <message>
        <source>Radius of the opening</source>
        <translation>Rayon de l&apos;ouverture</translation>
    </message>
    <message>
        <source>Opening along the path</source>
        <translation>Ouverture le long du trajet</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PictureDialog</name>
    <message>
        <source>C%1</source>
        <translation>C%1</translation>
    </message>
    <message>
        <source>Both 3-D views</source>
        <translation>Les deux vues 3D</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>Toutes les vues</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>With crosshair, text and scale</source>
        <translation>Avec réticule, texte et échelle</translation>
    </message>
    <message>
        <source>Save a picture</source>
        <translation>Enregistrer une image</translation>
    </message>
    <message>
        <source>Save a turntable</source>
        <translation>Enregistrer une rotation</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vues</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Pictures in a turn</source>
        <translation>Images par tour</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Images par seconde</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PictureExports</name>
    <message>
        <source>Save a picture</source>
        <translation>Enregistrer une image</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>No 3-D view is on screen that could turn.</source>
        <translation>Aucune vue 3D à l&apos;écran ne peut tourner.</translation>
    </message>
    <message>
        <source>PNG, one for each picture</source>
        <translation>PNG, un par image</translation>
    </message>
    <message>
        <source>MP4 film</source>
        <translation>Film MP4</translation>
    </message>
    <message>
        <source>Save a turntable</source>
        <translation>Enregistrer une rotation</translation>
    </message>
    <message>
        <source>Drawing %1…</source>
        <translation>Dessin de %1…</translation>
    </message>
    <message>
        <source>%1 exists already: choose another name, or delete the pictures of an earlier turntable.</source>
        <translation>%1 existe déjà&#xa0;: choisissez un autre nom, ou supprimez les images d&apos;une rotation antérieure.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 écrit</translation>
    </message>
    <message>
        <source>Copied the picture</source>
        <translation>Image copiée</translation>
    </message>
    <message>
        <source>ffmpeg cannot be started; save PNGs instead.</source>
        <translation>ffmpeg ne peut pas être lancé&#xa0;; enregistrez plutôt des PNG.</translation>
    </message>
    <message>
        <source>ffmpeg could not write %1: %2</source>
        <translation>ffmpeg n&apos;a pas pu écrire %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 ne peut pas être écrit&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PictureMaker</name>
    <message>
        <source>There is no memory for a picture of %1 × %2 pixels.</source>
        <translation>Pas assez de mémoire pour une image de %1 × %2 pixels.</translation>
    </message>
    <message>
        <source>C%1</source>
        <translation>C%1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PlacementController</name>
    <message>
        <source>The focus cannot be measured: %1</source>
        <translation>La cible ne peut pas être mesurée&#xa0;: %1</translation>
    </message>
    <message>
        <source>No view of that point: %1</source>
        <translation>Pas de vue de ce point&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PlacementForm</name>
    <message>
        <source>Place the cameras when a focus is chosen</source>
        <translation>Placer les caméras au choix d&apos;une cible</translation>
    </message>
    <message>
        <source>Second view follows the first</source>
        <translation>La seconde vue suit la première</translation>
    </message>
    <message>
        <source>Find both views together</source>
        <translation>Chercher les deux vues ensemble</translation>
    </message>
    <message>
        <source>The focus</source>
        <translation>La cible</translation>
    </message>
    <message>
        <source>A point clicked on a slice</source>
        <translation>Un point cliqué sur une coupe</translation>
    </message>
    <message>
        <source>What the cameras look at.
The focus: its best view and one that complements it.
A point clicked on a slice: a click there turns both views to the structure at that point, which needs no label (LiveSync, Kohlmann et al. 2007)</source>
        <translation>Ce que regardent les caméras.
La cible&#xa0;: sa meilleure vue et une qui la complète.
Un point cliqué sur une coupe&#xa0;: un clic tourne les deux vues vers la structure à ce point, qui n&apos;a pas besoin d&apos;étiquette (LiveSync, Kohlmann et al. 2007)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>How far from the point its structure counts</source>
        <translation>Jusqu&apos;à quelle distance du point sa structure compte</translation>
    </message>
    <message numerus="yes">
        <source>%n views</source>
        <translation>
            <numerusform>%n vue</numerusform>
            <numerusform>%n vues</numerusform>
        </translation>
    </message>
    <message>
        <source>Finer near the best</source>
        <translation>Plus fin près des meilleures</translation>
    </message>
    <message>
        <source>From how many sides the focus is looked at, evenly all around (12·n² HEALPix directions), or ever finer around the best ones</source>
        <translation>De combien de côtés la cible est regardée, régulièrement tout autour (12·n² directions HEALPix), ou de plus en plus fin autour des meilleures</translation>
    </message>
    <message>
        <source>To its right</source>
        <translation>À sa droite</translation>
    </message>
    <message>
        <source>All around</source>
        <translation>Tout autour</translation>
    </message>
    <message>
        <source>Where the second view may be, always 60° to 120° from the first.
To its right: the half sphere c2·a ≥ 0 around the first view&apos;s right axis a. All around: the band |c1·c2| ≤ sin δ</source>
        <translation>Où la seconde vue peut être, toujours à 60°–120° de la première.
À sa droite&#xa0;: la demi-sphère c2·a ≥ 0 autour de l&apos;axe droit a de la première vue. Tout autour&#xa0;: la bande |c1·c2| ≤ sin δ</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>δ: how far the second view may leave the right angle to the first</source>
        <translation>δ&#xa0;: de combien la seconde vue peut s&apos;écarter de l&apos;angle droit avec la première</translation>
    </message>
    <message>
        <source>Choose the two views that together see most of the focus&apos;s surface.
Off: first the best view, then the best one beside it</source>
        <translation>Choisit les deux vues qui voient ensemble le plus de la surface de la cible.
Sinon&#xa0;: d&apos;abord la meilleure vue, puis la meilleure à côté</translation>
    </message>
    <message>
        <source>What two views are chosen by: w · share of the surface seen + (1 − w) · mean quality of the views</source>
        <translation>Critère du choix de deux vues&#xa0;: w · part de surface vue + (1 − w) · qualité moyenne des vues</translation>
    </message>
    <message>
        <source>When the first view is turned, the second goes to the best view beside it</source>
        <translation>Quand la première vue tourne, la seconde va à la meilleure vue à côté</translation>
    </message>
    <message>
        <source>Cameras for</source>
        <translation>Caméras pour</translation>
    </message>
    <message>
        <source>Sides tried</source>
        <translation>Côtés essayés</translation>
    </message>
    <message>
        <source>Second view</source>
        <translation>Seconde vue</translation>
    </message>
    <message>
        <source>Off right angle</source>
        <translation>Hors angle droit</translation>
    </message>
    <message>
        <source>Surface seen</source>
        <translation>Surface vue</translation>
    </message>
    <message>
        <source>More weights</source>
        <translation>Autres poids</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Portée</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PresetPicker</name>
    <message>
        <source>Presets</source>
        <translation>Préréglages</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nom du préréglage</translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation>Importer un préréglage</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>Préréglages (*.json)</translation>
    </message>
    <message>
        <source>Export the preset</source>
        <translation>Exporter le préréglage</translation>
    </message>
    <message>
        <source>There is a preset &quot;%1&quot;. Replace it?</source>
        <translation>Il y a un préréglage «&#xa0;%1 ». Le remplacer&#xa0;?</translation>
    </message>
    <message>
        <source>Delete the preset &quot;%1&quot;?</source>
        <translation>Supprimer le préréglage «&#xa0;%1&#xa0;»&#xa0;?</translation>
    </message>
    <message>
        <source>Open a transfer function</source>
        <translation>Ouvrir une fonction de transfert</translation>
    </message>
    <message>
        <source>Transfer functions (*.json)</source>
        <translation>Fonctions de transfert (*.json)</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>Modifié</translation>
    </message>
    <message>
        <source>Transfer functions, and your own presets of the whole look</source>
        <translation>Fonctions de transfert, et vos préréglages de toute l&apos;apparence</translation>
    </message>
    <message>
        <source>Keep, import, export, rename and delete presets</source>
        <translation>Garder, importer, exporter, renommer et supprimer des préréglages</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>D&apos;un fichier…</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>Keep this look as a preset…</source>
        <translation>Garder cette apparence comme préréglage…</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renommer…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Supprimer…</translation>
    </message>
    <message>
        <source>Import a preset…</source>
        <translation>Importer un préréglage…</translation>
    </message>
    <message>
        <source>Export this look…</source>
        <translation>Exporter cette apparence…</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Apparence</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ReformatPanel</name>
    <message>
        <source>Dra&amp;w</source>
        <translation>&amp;Tracer</translation>
    </message>
    <message>
        <source>Follow the f&amp;ocus</source>
        <translation>Suivre la &amp;cible</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Click points on the slices; Backspace takes the last away, Enter or a double click ends the path</source>
        <translation>Cliquez des points sur les coupes&#xa0;; Retour arrière retire le dernier, Entrée ou un double clic termine le trajet</translation>
    </message>
    <message>
        <source>Finds the centre line of the tubular structure in focus</source>
        <translation>Trouve la ligne centrale de la structure tubulaire ciblée</translation>
    </message>
    <message>
        <source>Deletes the path</source>
        <translation>Supprime le trajet</translation>
    </message>
    <message>
        <source>Width of the pictures</source>
        <translation>Largeur des images</translation>
    </message>
    <message>
        <source>Turns the straightened picture about the path</source>
        <translation>Tourne l&apos;image redressée autour du trajet</translation>
    </message>
    <message>
        <source>Straightened along the path</source>
        <translation>Redressée le long du trajet</translation>
    </message>
    <message>
        <source>Across the path</source>
        <translation>En travers du trajet</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Tournée de</translation>
    </message>
    <message>
        <source>Delete the path</source>
        <translation>Supprimer le trajet</translation>
    </message>
    <message>
        <source>Bring a label or a region into focus first: a vessel, or another tube.</source>
        <translation>Ciblez d&apos;abord une étiquette ou une région&#xa0;: un vaisseau ou un autre tube.</translation>
    </message>
    <message>
        <source>Path along the focus</source>
        <translation>Trajet le long de la cible</translation>
    </message>
    <message>
        <source>The structure in focus is no tube: it is hardly longer than thick. Draw a path instead.</source>
        <translation>La structure ciblée n&apos;est pas un tube&#xa0;: elle n&apos;est guère plus longue qu&apos;épaisse. Tracez plutôt un trajet.</translation>
    </message>
    <message numerus="yes">
        <source>%n points; Enter ends the path</source>
        <translation>
            <numerusform>%n point&#x202f;; Entrée termine le trajet</numerusform>
            <numerusform>%n points&#x202f;; Entrée termine le trajet</numerusform>
        </translation>
    </message>
    <message>
        <source>Finding the centre line…</source>
        <translation>Recherche de la ligne centrale…</translation>
    </message>
    <message>
        <source>Draw a path on the slices, or follow the vessel that is in focus.</source>
        <translation>Tracez un trajet sur les coupes, ou suivez le vaisseau ciblé.</translation>
    </message>
    <message>
        <source>At %1 of %2 mm</source>
        <translation>À %1 sur %2 mm</translation>
    </message>
    <message>
        <source>Area %1 mm²</source>
        <translation>Aire %1 mm²</translation>
    </message>
    <message>
        <source>Radius %1 mm</source>
        <translation>Rayon %1 mm</translation>
    </message>
    <message>
        <source>Reading the structure in focus…</source>
        <translation>Lecture de la structure ciblée…</translation>
    </message>
    <message>
        <source>No structure in focus here: no area</source>
        <translation>Pas de structure ciblée ici&#xa0;: pas d&apos;aire</translation>
    </message>
    <message>
        <source>Cameras follow</source>
        <translation>Les caméras suivent</translation>
    </message>
    <message>
        <source>Both cameras keep the place on the path in the middle of their pictures as you move along it</source>
        <translation>Les deux caméras gardent la position du trajet au milieu de leurs images quand vous le parcourez</translation>
    </message>
    <message>
        <source>Open along the path</source>
        <translation>Ouvrir le long du trajet</translation>
    </message>
    <message>
        <source>The view opens to a tube around the path, which goes along when the path changes</source>
        <translation>La vue s&apos;ouvre jusqu&apos;à un tube autour du trajet, qui le suit quand il change</translation>
    </message>
    <message>
        <source>Radius of the tube that the view opens to</source>
        <translation>Rayon du tube jusqu&apos;où la vue s&apos;ouvre</translation>
    </message>
    <message>
        <source>The tube around the path is in focus: untick Open along the path, and bring a vessel into focus.</source>
        <translation>Le tube autour du trajet est la cible&#xa0;: décochez «&#xa0;Ouvrir le long du trajet&#xa0;» et prenez un vaisseau pour cible.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::RegionGrower</name>
    <message>
        <source>No region grows from there; click elsewhere.</source>
        <translation>Aucune région ne croît de là&#xa0;; cliquez ailleurs.</translation>
    </message>
    <message>
        <source>Nothing would be left of the region; it stays as it was.</source>
        <translation>Il ne resterait rien de la région&#xa0;; elle reste comme elle était.</translation>
    </message>
    <message>
        <source>That is air, which fills more than half of the volume; click a structure.</source>
        <translation>C&apos;est de l&apos;air, qui remplit plus de la moitié du volume&#xa0;; cliquez une structure.</translation>
    </message>
    <message>
        <source>No border holds the region there: it would fill more than half of the volume. Drag a ball around the structure (Shift+drag), or click elsewhere.</source>
        <translation>Aucune limite n&apos;y retient la région&#xa0;: elle remplirait plus de la moitié du volume. Tracez une boule autour de la structure (Maj+glisser), ou cliquez ailleurs.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::RegionPanel</name>
    <message>
        <source>Open the 3-D views to it</source>
        <translation>Ouvrir les vues 3D vers elle</translation>
    </message>
    <message>
        <source>Colour of the label</source>
        <translation>Couleur de l&apos;étiquette</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conserver</translation>
    </message>
    <message>
        <source>Shift+click adds to the region, Ctrl+click takes away. Shift+drag draws a ball around a structure, which its region does not leave.</source>
        <translation>Maj+clic ajoute à la région, Ctrl+clic en retire. Maj+glisser trace une boule autour d&apos;une structure, que sa région ne quitte pas.</translation>
    </message>
    <message>
        <source>How far values may lie from those at the click (Alt+wheel over a picture, keys , and .)</source>
        <translation>De combien les valeurs peuvent s&apos;écarter de celles du clic (Alt+molette sur une image, touches , et .)</translation>
    </message>
    <message>
        <source>Tolerance: how far values may lie below those at the click</source>
        <translation>Tolérance&#xa0;: de combien les valeurs peuvent être sous celles du clic</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>The tolerance is chosen from the plateaus</source>
        <translation>La tolérance est choisie d&apos;après les plateaux</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Radius of the ball around the click, which the region does not leave</source>
        <translation>Rayon de la boule autour du clic, que la région ne quitte pas</translation>
    </message>
    <message>
        <source>No ball</source>
        <translation>Sans boule</translation>
    </message>
    <message>
        <source>Nothing bounds the region</source>
        <translation>Rien ne borne la région</translation>
    </message>
    <message>
        <source>Within a ball of</source>
        <translation>Dans une boule de</translation>
    </message>
    <message>
        <source>Name of a label</source>
        <translation>Nom d&apos;une étiquette</translation>
    </message>
    <message>
        <source>Keep the region as a label of this study</source>
        <translation>Conserver la région comme étiquette de cet examen</translation>
    </message>
    <message>
        <source>Region: growing…</source>
        <translation>Région&#xa0;: en croissance…</translation>
    </message>
    <message>
        <source>That is %1 % of the body: the 3-D views do not open to it by themselves.</source>
        <translation>C&apos;est %1 % du corps&#xa0;: les vues 3D ne s&apos;ouvrent pas d&apos;elles-mêmes vers elle.</translation>
    </message>
    <message>
        <source>The 3-D views do not open to it by themselves.</source>
        <translation>Les vues 3D ne s&apos;ouvrent pas d&apos;elles-mêmes vers elle.</translation>
    </message>
    <message>
        <source>Region: %1</source>
        <translation>Région&#xa0;: %1</translation>
    </message>
    <message>
        <source>Region: %1 so far…</source>
        <translation>Région&#xa0;: %1 jusqu&apos;ici…</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ResultsDialog</name>
    <message>
        <source>Save results</source>
        <translation>Enregistrer les résultats</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Écriture…</translation>
    </message>
    <message>
        <source>Stopped. Nothing was written; an archive keeps what it had taken.</source>
        <translation>Arrêté. Rien n&apos;a été écrit ; une archive garde ce qu&apos;elle avait accepté.</translation>
    </message>
    <message>
        <source>Measures and the table of labels, as a report</source>
        <translation>Mesures et tableau des étiquettes, comme rapport</translation>
    </message>
    <message>
        <source>A structured report (TID 1500): distances, angles, areas and values of the measures, volume and values of each label, and the segmentation that these refer to</source>
        <translation>Un rapport structuré (TID 1500) : distances, angles, aires et valeurs des mesures, volume et valeurs de chaque étiquette, et la segmentation à laquelle ils se rapportent</translation>
    </message>
    <message>
        <source>All labels, as a segmentation</source>
        <translation>Toutes les étiquettes, comme segmentation</translation>
    </message>
    <message>
        <source>With their names and colours</source>
        <translation>Avec leurs noms et couleurs</translation>
    </message>
    <message>
        <source>The focus, as a segmentation</source>
        <translation>La cible, comme segmentation</translation>
    </message>
    <message>
        <source>Labels as they are; a region or a range of values as one segment</source>
        <translation>Les étiquettes telles quelles ; une région ou une plage de valeurs comme un segment</translation>
    </message>
    <message>
        <source>A picture of</source>
        <translation>Une image de</translation>
    </message>
    <message>
        <source>A secondary capture, which says what makes the picture less than exact</source>
        <translation>Une capture secondaire, qui dit ce qui rend l&apos;image moins exacte</translation>
    </message>
    <message>
        <source>Views in the picture</source>
        <translation>Vues dans l&apos;image</translation>
    </message>
    <message>
        <source>A key object selection, which names slices of the series</source>
        <translation>Une sélection d&apos;objets clés, qui nomme des coupes de la série</translation>
    </message>
    <message>
        <source>by the kind of object</source>
        <translation>selon le type d&apos;objet</translation>
    </message>
    <message>
        <source>Description of the series</source>
        <translation>Description de la série</translation>
    </message>
    <message>
        <source>To the folder</source>
        <translation>Dans le dossier</translation>
    </message>
    <message>
        <source>A file for each object</source>
        <translation>Un fichier pour chaque objet</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>To the archive</source>
        <translation>Vers l&apos;archive</translation>
    </message>
    <message>
        <source>The server answers for each object</source>
        <translation>Le serveur répond pour chaque objet</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Serveur</translation>
    </message>
    <message>
        <source>The objects hold the patient&apos;s name and ID, also while the window hides them: archives and other programs file them by these.</source>
        <translation>Les objets contiennent le nom et l&apos;ID du patient, même quand la fenêtre les masque : archives et autres programmes les classent par eux.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Folder of the results</source>
        <translation>Dossier des résultats</translation>
    </message>
    <message>
        <source>This study is not from DICOM files, so there is no DICOM study that this could belong to.</source>
        <translation>Cet examen ne vient pas de fichiers DICOM : il n&apos;y a pas d&apos;examen DICOM auquel cela pourrait appartenir.</translation>
    </message>
    <message>
        <source>Nothing is in focus.</source>
        <translation>Rien n&apos;est ciblé.</translation>
    </message>
    <message>
        <source>The region in focus is not complete yet.</source>
        <translation>La région ciblée n&apos;est pas encore complète.</translation>
    </message>
    <message>
        <source>This series was read from an archive file. Unpack it and open the folder.</source>
        <translation>Cette série a été lue d&apos;un fichier compressé. Décompressez-le et ouvrez le dossier.</translation>
    </message>
    <message>
        <source>The slices of this series do not lie evenly: what is shown is interpolated between them.</source>
        <translation>Les coupes de cette série ne sont pas régulières : ce qui est montré est interpolé entre elles.</translation>
    </message>
    <message>
        <source>There are no key images (View → Keep a key image).</source>
        <translation>Il n&apos;y a pas d&apos;images clés (Affichage → Garder une image clé).</translation>
    </message>
    <message>
        <source>The crosshair of no key image lies in the volume.</source>
        <translation>Le réticule d&apos;aucune image clé n&apos;est dans le volume.</translation>
    </message>
    <message>
        <source>There are neither measures nor labels.</source>
        <translation>Il n&apos;y a ni mesures ni étiquettes.</translation>
    </message>
    <message>
        <source>There are no labels.</source>
        <translation>Il n&apos;y a pas d&apos;étiquettes.</translation>
    </message>
    <message>
        <source>No view is on screen.</source>
        <translation>Aucune vue n&apos;est à l&apos;écran.</translation>
    </message>
    <message>
        <source>Slices of the key images: %1</source>
        <translation>Coupes des images clés : %1</translation>
    </message>
    <message>
        <source>Slices of the key images</source>
        <translation>Coupes des images clés</translation>
    </message>
    <message>
        <source>This study is not from DICOM files, and archives file by patient and study.</source>
        <translation>Cet examen ne vient pas de fichiers DICOM, et les archives classent par patient et examen.</translation>
    </message>
    <message>
        <source>No server is entered yet (View → Archive).</source>
        <translation>Aucun serveur n&apos;est encore saisi (Affichage → Archive).</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Région</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Values %1 to %2 %3</source>
        <translation>Valeurs de %1 à %2 %3</translation>
    </message>
    <message>
        <source>Drawing the picture…</source>
        <translation>Dessin de l&apos;image…</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 écrit.</translation>
    </message>
    <message>
        <source>Nothing was sent: %1</source>
        <translation>Rien n&apos;a été envoyé : %1</translation>
    </message>
    <message>
        <source>Ask the archive to confirm that it keeps them</source>
        <translation>Demander à l&apos;archive de confirmer qu&apos;elle les conserve</translation>
    </message>
    <message>
        <source>DICOMweb has no such confirmation</source>
        <translation>DICOMweb n&apos;a pas de telle confirmation</translation>
    </message>
    <message>
        <source>A storage commitment: the archive says of each object whether it is stored safely. Most connect to our address and port for that, which are open meanwhile</source>
        <translation>Un engagement de stockage (storage commitment) : l&apos;archive dit de chaque objet s&apos;il est stocké en sûreté. La plupart se connectent pour cela à notre adresse et à notre port, ouverts pendant ce temps</translation>
    </message>
    <message>
        <source>None is confirmed to be kept: %1</source>
        <translation>Aucun n&apos;est confirmé comme conservé : %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::RetrievalRow</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Waits for others</source>
        <translation>Attend les autres</translation>
    </message>
    <message>
        <source>Stops…</source>
        <translation>Arrêt…</translation>
    </message>
    <message>
        <source>Paused; what came is kept</source>
        <translation>En pause&#xa0;; ce qui est arrivé est conservé</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Complète</translation>
    </message>
    <message>
        <source>Cancels it, and takes it out of the list. What came stays in the cache</source>
        <translation>L&apos;annule et la retire de la liste. Ce qui est arrivé reste dans le cache</translation>
    </message>
    <message>
        <source>Retrieval %1</source>
        <translation>Récupération %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Retrievals</name>
    <message>
        <source>The server needs a login.</source>
        <translation>Le serveur demande une connexion.</translation>
    </message>
    <message>
        <source>Its server is no longer in the list.</source>
        <translation>Son serveur n&apos;est plus dans la liste.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SearchForm</name>
    <message>
        <source>Search</source>
        <translation>Chercher</translation>
    </message>
    <message>
        <source>Asks the server for the studies that match. Empty fields match all (Return)</source>
        <translation>Demande au serveur les examens qui correspondent. Les champs vides valent pour tous (Entrée)</translation>
    </message>
    <message>
        <source>Saved searches</source>
        <translation>Recherches enregistrées</translation>
    </message>
    <message>
        <source>Searches under a name. A patient&apos;s name, ID and accession number are not saved</source>
        <translation>Recherches sous un nom. Le nom, l&apos;ID et le numéro d&apos;accession d&apos;un patient ne sont pas enregistrés</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Accession</source>
        <translation>Accession</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Description</translation>
    </message>
    <message>
        <source>An asterisk stands for any text, a question mark for one character</source>
        <translation>Un astérisque vaut pour tout texte, un point d&apos;interrogation pour un caractère</translation>
    </message>
    <message>
        <source>Family name, or &quot;Doe, Jane&quot;: all names that begin so. %1, as in *jane*</source>
        <translation>Nom de famille, ou «&#xa0;Doe, Jane&#xa0;»&#xa0;: tous les noms qui commencent ainsi. %1, comme dans *jane*</translation>
    </message>
    <message>
        <source>The patient&apos;s ID as it is. %1, as in 47*</source>
        <translation>L&apos;ID du patient tel quel. %1, comme dans 47*</translation>
    </message>
    <message>
        <source>The accession number as it is. %1, as in A2024*</source>
        <translation>Le numéro d&apos;accession tel quel. %1, comme dans A2024*</translation>
    </message>
    <message>
        <source>All descriptions of studies that hold this text. %1, as in head*</source>
        <translation>Toutes les descriptions d&apos;examens qui contiennent ce texte. %1, comme dans head*</translation>
    </message>
    <message>
        <source>The kind of images that the study holds</source>
        <translation>Le type d&apos;images que contient l&apos;examen</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Indifférent</translation>
    </message>
    <message>
        <source>When the study was made</source>
        <translation>Date de l&apos;examen</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Aujourd&apos;hui</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>7 derniers jours</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>30 derniers jours</translation>
    </message>
    <message>
        <source>Last 365 days</source>
        <translation>365 derniers jours</translation>
    </message>
    <message>
        <source>From … to</source>
        <translation>Du … au</translation>
    </message>
    <message>
        <source>First day</source>
        <translation>Premier jour</translation>
    </message>
    <message>
        <source>Last day</source>
        <translation>Dernier jour</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Save this search…</source>
        <translation>Enregistrer cette recherche…</translation>
    </message>
    <message>
        <source>Save this search</source>
        <translation>Enregistrer cette recherche</translation>
    </message>
    <message>
        <source>Its name (date, type and description are saved, nothing of a patient):</source>
        <translation>Son nom (date, type et description sont enregistrés, rien d&apos;un patient)&#xa0;:</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Oublier</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SendDialog</name>
    <message>
        <source>Nothing is open.</source>
        <translation>Rien n&apos;est ouvert.</translation>
    </message>
    <message>
        <source>What is open is not DICOM, and archives keep nothing else.</source>
        <translation>Ce qui est ouvert n&apos;est pas DICOM, et les archives ne conservent rien d&apos;autre.</translation>
    </message>
    <message>
        <source>Send to an archive</source>
        <translation>Envoyer à une archive</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Envoyer</translation>
    </message>
    <message>
        <source>The server that gets the objects</source>
        <translation>Le serveur qui reçoit les objets</translation>
    </message>
    <message>
        <source>The open series, images: %1</source>
        <translation>La série ouverte, images&#xa0;: %1</translation>
    </message>
    <message>
        <source>Its files as they are</source>
        <translation>Ses fichiers tels quels</translation>
    </message>
    <message>
        <source>All labels, as a DICOM segmentation</source>
        <translation>Toutes les étiquettes, en segmentation DICOM</translation>
    </message>
    <message>
        <source>With their names and colours, for the patient and the series that are open</source>
        <translation>Avec leurs noms et couleurs, pour le patient et la série ouverts</translation>
    </message>
    <message>
        <source>The objects hold the patient&apos;s name and ID: an archive files them by these.</source>
        <translation>Les objets contiennent le nom et l&apos;ID du patient&#xa0;: une archive les classe ainsi.</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Serveur</translation>
    </message>
    <message>
        <source>Image %1</source>
        <translation>Image %1</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Étiquettes</translation>
    </message>
    <message>
        <source>Ask the archive to confirm that it keeps them</source>
        <translation>Demander à l&apos;archive de confirmer qu&apos;elle les conserve</translation>
    </message>
    <message>
        <source>DICOMweb has no such confirmation</source>
        <translation>DICOMweb n&apos;a pas de telle confirmation</translation>
    </message>
    <message>
        <source>A storage commitment: the archive says of each object whether it is stored safely. Most connect to our address and port for that, which are open meanwhile</source>
        <translation>Un engagement de stockage (storage commitment) : l&apos;archive dit de chaque objet s&apos;il est stocké en sûreté. La plupart se connectent pour cela à notre adresse et à notre port, ouverts pendant ce temps</translation>
    </message>
    <message>
        <source>None is confirmed to be kept: %1</source>
        <translation>Aucun n&apos;est confirmé comme conservé : %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SentAnswers</name>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Answer of the server</source>
        <translation>Réponse du serveur</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>accepté</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusé</translation>
    </message>
    <message>
        <source>Accepted: %1 of %2.</source>
        <translation>Acceptés&#xa0;: %1 sur %2.</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>conservé</translation>
    </message>
    <message>
        <source>not kept: %1</source>
        <translation>non conservé : %1</translation>
    </message>
    <message>
        <source>not confirmed to be kept</source>
        <translation>conservation non confirmée</translation>
    </message>
    <message>
        <source>Confirmed to be kept: %1 of %2.</source>
        <translation>Conservation confirmée : %1 sur %2.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SeriesPanel</name>
    <message>
        <source>Series</source>
        <translation>Séries</translation>
    </message>
    <message>
        <source>Patient %1</source>
        <translation>Patient %1</translation>
    </message>
    <message>
        <source>Patient without a name</source>
        <translation>Patient sans nom</translation>
    </message>
    <message>
        <source>1 image</source>
        <translation>1 image</translation>
    </message>
    <message numerus="yes">
        <source>%n images</source>
        <translation>
            <numerusform>%n image</numerusform>
            <numerusform>%n images</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, open</source>
        <translation>%1, ouverte</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open beside</source>
        <translation>Ouvrir à côté</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ServerDialog</name>
    <message>
        <source>Archive server</source>
        <translation>Serveur d&apos;archives</translation>
    </message>
    <message>
        <source>As you call it</source>
        <translation>Comme vous l&apos;appelez</translation>
    </message>
    <message>
        <source>DICOM</source>
        <translation>DICOM</translation>
    </message>
    <message>
        <source>DICOM over TLS</source>
        <translation>DICOM sur TLS</translation>
    </message>
    <message>
        <source>DICOMweb</source>
        <translation>DICOMweb</translation>
    </message>
    <message>
        <source>What the server speaks; its administrator knows</source>
        <translation>Ce que parle le serveur&#xa0;; son administrateur le sait</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Speaks</source>
        <translation>Parle</translation>
    </message>
    <message>
        <source>Its name or address in the network</source>
        <translation>Son nom ou son adresse dans le réseau</translation>
    </message>
    <message>
        <source>The port that it listens on</source>
        <translation>Le port sur lequel il écoute</translation>
    </message>
    <message>
        <source>Its AE title, at most 16 letters and digits</source>
        <translation>Son titre AE, au plus 16 lettres et chiffres</translation>
    </message>
    <message>
        <source>Our AE title: its administrator enters it at the server</source>
        <translation>Notre titre AE&#xa0;: l&apos;administrateur l&apos;enregistre sur le serveur</translation>
    </message>
    <message>
        <source>C-GET, over our connection</source>
        <translation>C-GET, par notre connexion</translation>
    </message>
    <message>
        <source>C-MOVE, the server connects to us</source>
        <translation>C-MOVE, le serveur se connecte à nous</translation>
    </message>
    <message>
        <source>How objects come. C-GET needs nothing more; with C-MOVE our address and port are entered at the server, and the port is open while objects come</source>
        <translation>Comment les objets arrivent. C-GET n&apos;a besoin de rien d&apos;autre&#xa0;; avec C-MOVE, notre adresse et notre port sont enregistrés sur le serveur, et le port est ouvert pendant que les objets arrivent</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Hôte</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Its AE title</source>
        <translation>Son titre AE</translation>
    </message>
    <message>
        <source>Our AE title</source>
        <translation>Notre titre AE</translation>
    </message>
    <message>
        <source>Retrieve by</source>
        <translation>Récupérer par</translation>
    </message>
    <message>
        <source>Our address</source>
        <translation>Notre adresse</translation>
    </message>
    <message>
        <source>Our port</source>
        <translation>Notre port</translation>
    </message>
    <message>
        <source>The address of DICOMweb&apos;s root. A login goes out over https alone</source>
        <translation>L&apos;adresse de la racine de DICOMweb. Une connexion ne part que par https</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>User and password</source>
        <translation>Utilisateur et mot de passe</translation>
    </message>
    <message>
        <source>Token</source>
        <translation>Jeton</translation>
    </message>
    <message>
        <source>Who you are to the server</source>
        <translation>Qui vous êtes pour le serveur</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>Connexion</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Utilisateur</translation>
    </message>
    <message>
        <source>Certificates that may sign the server&apos;s</source>
        <translation>Certificats qui peuvent signer celui du serveur</translation>
    </message>
    <message>
        <source>Certificates in PEM that may sign the server&apos;s, or its own</source>
        <translation>Certificats en PEM qui peuvent signer celui du serveur, ou le sien</translation>
    </message>
    <message>
        <source>Our certificate</source>
        <translation>Notre certificat</translation>
    </message>
    <message>
        <source>In PEM, where the server asks for one</source>
        <translation>En PEM, si le serveur en demande un</translation>
    </message>
    <message>
        <source>The key of our certificate</source>
        <translation>La clé de notre certificat</translation>
    </message>
    <message>
        <source>In PEM, without a passphrase</source>
        <translation>En PEM, sans phrase secrète</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>Certificats de confiance</translation>
    </message>
    <message>
        <source>Its key</source>
        <translation>Sa clé</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Choisir le fichier</translation>
    </message>
    <message>
        <source>Certificates and keys (*.pem *.crt *.cer *.key);;All files (*)</source>
        <translation>Certificats et clés (*.pem *.crt *.cer *.key);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Token for %1:</source>
        <translation>Jeton pour %1&#xa0;:</translation>
    </message>
    <message>
        <source>Password of %1 for %2:</source>
        <translation>Mot de passe de %1 pour %2&#xa0;:</translation>
    </message>
    <message>
        <source>Address of this machine that the server sends to: objects by C-MOVE, and whether it keeps what it was sent</source>
        <translation>Adresse de cette machine à laquelle le serveur envoie : les objets par C-MOVE, et s&apos;il conserve ce qui lui a été envoyé</translation>
    </message>
    <message>
        <source>Port of this machine that the server sends to; it is open while that is waited for</source>
        <translation>Port de cette machine auquel le serveur envoie ; il est ouvert tant qu&apos;on l&apos;attend</translation>
    </message>
    <message>
        <source>The password or token is asked for when it is needed</source>
        <translation>Le mot de passe ou le jeton est demandé quand il le faut</translation>
    </message>
    <message>
        <source>Keep the password or token in the key ring</source>
        <translation>Conserver le mot de passe ou le jeton dans le trousseau</translation>
    </message>
    <message>
        <source>The password or token is kept where the desktop keeps those of other programs, encrypted, and nowhere else. Otherwise it is forgotten when the program ends</source>
        <translation>Le mot de passe ou le jeton est conservé là où le bureau garde ceux des autres programmes, chiffré, et nulle part ailleurs. Sinon il est oublié à la fin du programme</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Sessions</name>
    <message>
        <source>Sessions</source>
        <translation>Sessions</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Travail non enregistré</translation>
    </message>
    <message>
        <source>These changes since the last save would be lost. Save them?</source>
        <translation>Ces modifications depuis le dernier enregistrement seraient perdues. Les enregistrer&#xa0;?</translation>
    </message>
    <message>
        <source>Where is the data now?</source>
        <translation>Où sont les données maintenant&#xa0;?</translation>
    </message>
    <message>
        <source>The session&apos;s label map is needed.</source>
        <translation>La carte d&apos;étiquettes de la session est nécessaire.</translation>
    </message>
    <message>
        <source>The session&apos;s volume is needed.</source>
        <translation>Le volume de la session est nécessaire.</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Choisir un fichier…</translation>
    </message>
    <message>
        <source>Choose a folder…</source>
        <translation>Choisir un dossier…</translation>
    </message>
    <message>
        <source>The data</source>
        <translation>Les données</translation>
    </message>
    <message>
        <source>The data&apos;s folder</source>
        <translation>Le dossier des données</translation>
    </message>
    <message>
        <source>%1 %2. Say it here:</source>
        <translation>%1 %2. Indiquez-la ici&#xa0;:</translation>
    </message>
    <message>
        <source>Fenestra ended before the session was saved. A copy from %1 can be restored.</source>
        <translation>Fenestra s&apos;est arrêté avant l&apos;enregistrement de la session. Une copie du %1 peut être restaurée.</translation>
    </message>
    <message>
        <source>Fenestra ended before the work on %1 was saved. A copy from %2 can be restored.</source>
        <translation>Fenestra s&apos;est arrêté avant l&apos;enregistrement du travail sur %1. Une copie du %2 peut être restaurée.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Ask later</source>
        <translation>Demander plus tard</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n autre</numerusform>
            <numerusform>%n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Enregistrer la session</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>Ouvrir une session</translation>
    </message>
    <message>
        <source>The labels that you kept are in no file yet, and reading the data again would drop them. Save the session first.</source>
        <translation>Les étiquettes conservées ne sont encore dans aucun fichier, et relire les données les perdrait. Enregistrez d&apos;abord la session.</translation>
    </message>
    <message>
        <source>The restored work</source>
        <translation>Le travail restauré</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SliceView</name>
    <message>
        <source>Not yet as asked for</source>
        <translation>Pas encore ce qui est demandé</translation>
    </message>
    <message>
        <source>Interpolated, not scanned</source>
        <translation>Interpolé, non acquis</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Radiological</source>
        <translation>Radiologique</translation>
    </message>
    <message>
        <source>L %1</source>
        <translation>N %L1</translation>
    </message>
    <message>
        <source>W %1</source>
        <translation>L %L1</translation>
    </message>
    <message>
        <source>inverted</source>
        <translation>inversé</translation>
    </message>
    <message>
        <source>Oblique, %1° from %2</source>
        <translation>Oblique, %1° de %2</translation>
    </message>
    <message>
        <source>Faces C1, %1° from %2</source>
        <translation>Face à C1, %1° de %2</translation>
    </message>
    <message>
        <source>Faces C2, %1° from %2</source>
        <translation>Face à C2, %1° de %2</translation>
    </message>
    <message>
        <source>Neurological</source>
        <translation>Neurologique</translation>
    </message>
    <message>
        <source>flipped</source>
        <translation>retourné</translation>
    </message>
    <message>
        <source>turned by %1°</source>
        <translation>tourné de %1°</translation>
    </message>
    <message>
        <source>true size</source>
        <translation>taille réelle</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SpacingDialog</name>
    <message>
        <source>Size of the voxels</source>
        <translation>Taille des voxels</translation>
    </message>
    <message>
        <source>&amp;Across a row</source>
        <translation>&amp;Le long d&apos;une ligne</translation>
    </message>
    <message>
        <source>&amp;Down a column</source>
        <translation>Le long &amp;d&apos;une colonne</translation>
    </message>
    <message>
        <source>From &amp;slice to slice</source>
        <translation>De &amp;coupe en coupe</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>non indiqué</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SphereMap</name>
    <message>
        <source>How good each viewpoint is, from dark to bright; click to look from there</source>
        <translation>Qualité de chaque point de vue, du sombre au clair&#xa0;; cliquer pour regarder de là</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StatusBar</name>
    <message>
        <source>Software OpenGL</source>
        <translation>OpenGL logiciel</translation>
    </message>
    <message>
        <source>Pictures are smaller while something moves: %1 draws them</source>
        <translation>Les images sont plus petites tant que quelque chose bouge&#xa0;: %1 les dessine</translation>
    </message>
    <message>
        <source>No OpenGL: slices only</source>
        <translation>Pas d&apos;OpenGL&#xa0;: coupes seules</translation>
    </message>
    <message>
        <source>Time until the last picture was on screen, and its sampling</source>
        <translation>Temps jusqu&apos;à l&apos;affichage de la dernière image, et son échantillonnage</translation>
    </message>
    <message>
        <source>Radiological convention</source>
        <translation>Convention radiologique</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%L1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%L1 s</translation>
    </message>
    <message>
        <source>, %1 % size</source>
        <translation>, %1 % de la taille</translation>
    </message>
    <message>
        <source>Neurological convention</source>
        <translation>Convention neurologique</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StrokeList</name>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Clear all</source>
        <translation>Tout effacer</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Charger…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Tick the strokes to apply</source>
        <translation>Cochez les traits à appliquer</translation>
    </message>
    <message>
        <source>Adds the strokes of a file</source>
        <translation>Ajoute les traits d&apos;un fichier</translation>
    </message>
    <message>
        <source>Clear strokes</source>
        <translation>Effacer les traits</translation>
    </message>
    <message>
        <source>Load brush strokes</source>
        <translation>Charger des traits de pinceau</translation>
    </message>
    <message>
        <source>Brush strokes (*.json)</source>
        <translation>Traits de pinceau (*.json)</translation>
    </message>
    <message>
        <source>Brush strokes</source>
        <translation>Traits de pinceau</translation>
    </message>
    <message>
        <source>Save brush strokes</source>
        <translation>Enregistrer les traits de pinceau</translation>
    </message>
    <message>
        <source>Delete stroke</source>
        <translation>Supprimer le trait</translation>
    </message>
    <message>
        <source>Delete strokes</source>
        <translation>Supprimer les traits</translation>
    </message>
    <message>
        <source>Load strokes</source>
        <translation>Charger les traits</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StrokeModel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>to the surface</source>
        <translation>jusqu&apos;à la surface</translation>
    </message>
    <message>
        <source>%1 mm deep</source>
        <translation>%L1 mm de profondeur</translation>
    </message>
    <message>
        <source>over the focus</source>
        <translation>sur la cible</translation>
    </message>
    <message>
        <source>C%1 only</source>
        <translation>C%1 seule</translation>
    </message>
    <message>
        <source>Hide stroke</source>
        <translation>Masquer le trait</translation>
    </message>
    <message>
        <source>Show stroke</source>
        <translation>Afficher le trait</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StudyLinkBar</name>
    <message>
        <source>Link</source>
        <translation>Lier</translation>
    </message>
    <message>
        <source>The crosshair, scrolling, zoom and turning of one study go along with those of the other, by patient position</source>
        <translation>Le réticule, le défilement, le zoom et la rotation d’un examen suivent ceux de l’autre, par la position du patient</translation>
    </message>
    <message>
        <source>Match points</source>
        <translation>Apparier les points</translation>
    </message>
    <message>
        <source>The crosshairs of both studies mark the same point: link the studies by it</source>
        <translation>Les réticules des deux examens marquent le même point : lier les examens par lui</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Forget the pair of points: the same coordinates are the same point</source>
        <translation>Oublier la paire de points : les mêmes coordonnées sont le même point</translation>
    </message>
    <message>
        <source>not linked</source>
        <translation>non lié</translation>
    </message>
    <message>
        <source>linked by patient position</source>
        <translation>lié par la position du patient</translation>
    </message>
    <message>
        <source>linked, offset %1, %2, %3 mm</source>
        <translation>lié, décalage %1, %2, %3 mm</translation>
    </message>
    <message>
        <source>Offset of the other study to the patient&apos;s left, posterior and superior</source>
        <translation>Décalage de l’autre examen vers la gauche, l’arrière et le haut du patient</translation>
    </message>
    <message>
        <source>Left study</source>
        <translation>Examen de gauche</translation>
    </message>
    <message>
        <source>Right study</source>
        <translation>Examen de droite</translation>
    </message>
    <message>
        <source>%1, active</source>
        <translation>%1, actif</translation>
    </message>
    <message>
        <source>%1 mm apart, where a study ends</source>
        <translation>à %1 mm, où un examen finit</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StudyNotices</name>
    <message numerus="yes">
        <source>There are %n time points here; this is number %1.</source>
        <translation>
            <numerusform>Il y a %n instant ici&#xa0;; voici le numéro %1.</numerusform>
            <numerusform>Il y a %n instants ici&#xa0;; voici le numéro %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>There are %n series here; open is %1.</source>
        <translation>
            <numerusform>Il y a %n série ici&#xa0;; %1 est ouverte.</numerusform>
            <numerusform>Il y a %n séries ici&#xa0;; %1 est ouverte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>A segmentation of this series lies beside it: %1.</source>
        <translation>Une segmentation de cette série se trouve à côté&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message numerus="yes">
        <source>%n segmentations of this series lie beside it.</source>
        <translation>
            <numerusform>%n segmentation de cette série se trouve à côté.</numerusform>
            <numerusform>%n segmentations de cette série se trouvent à côté.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::TagsPanel</name>
    <message>
        <source>Search tags, names and values</source>
        <translation>Chercher attributs, noms et valeurs</translation>
    </message>
    <message>
        <source>DICOM tags</source>
        <translation>Attributs DICOM</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>VR</source>
        <translation>VR</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>This study is no DICOM series: its format is %1, which has no DICOM tags.</source>
        <translation>Cet examen n&apos;est pas une série DICOM&#xa0;: son format est&#xa0;%1, qui n&apos;a pas d&apos;attributs DICOM.</translation>
    </message>
    <message>
        <source>This series was read from an archive. Unpack it and open the folder to see its tags.</source>
        <translation>Cette série a été lue dans une archive. Décompressez-la et ouvrez le dossier pour voir ses attributs.</translation>
    </message>
    <message>
        <source>The slices of this series do not lie evenly. What is shown is interpolated between them, and no file holds it.</source>
        <translation>Les coupes de cette série ne sont pas régulières. Ce qui est montré est interpolé entre elles, et aucun fichier ne le contient.</translation>
    </message>
    <message>
        <source>This plane is turned and crosses several files. Reset it (View → Slices), or click another view.</source>
        <translation>Ce plan est tourné et traverse plusieurs fichiers. Réinitialisez-le (Affichage → Coupes), ou cliquez dans une autre vue.</translation>
    </message>
    <message>
        <source>The file of this slice cannot be read.</source>
        <translation>Le fichier de cette coupe ne peut pas être lu.</translation>
    </message>
    <message>
        <source>Slice %1 of %2</source>
        <translation>Coupe&#xa0;%1 sur&#xa0;%2</translation>
    </message>
    <message>
        <source>%1, at the crosshair</source>
        <translation>%1, au réticule</translation>
    </message>
    <message>
        <source>1 item</source>
        <translation>1 élément</translation>
    </message>
    <message numerus="yes">
        <source>%n items</source>
        <translation>
            <numerusform>%n élément</numerusform>
            <numerusform>%n éléments</numerusform>
        </translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>masqué</translation>
    </message>
    <message>
        <source>Item %1</source>
        <translation>Élément&#xa0;%1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::TolerancePlot</name>
    <message>
        <source>%1 ml</source>
        <translation>%L1 ml</translation>
    </message>
    <message>
        <source>The region&apos;s volume against its tolerance, both logarithmic. A cliff is a leak; green marks where the region hardly changes</source>
        <translation>Volume de la région selon sa tolérance, tous deux logarithmiques. Une falaise est une fuite&#xa0;; le vert marque où la région change à peine</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Tour</name>
    <message>
        <source>End the tour</source>
        <translation>Terminer la visite</translation>
    </message>
    <message>
        <source>One body, five views</source>
        <translation>Un corps, cinq vues</translation>
    </message>
    <message>
        <source>Above are two 3-D views, C1 and C2; below are three slices. The torso opens with several structures in focus: what hides them is cut away.</source>
        <translation>En haut, deux vues 3D, C1 et C2&#xa0;; en bas, trois coupes. Le torse s&apos;ouvre avec plusieurs structures ciblées&#xa0;: ce qui les cache est enlevé.</translation>
    </message>
    <message>
        <source>Choose a structure</source>
        <translation>Choisir une structure</translation>
    </message>
    <message>
        <source>A click on the left kidney in the axial slice makes it the focus. The cameras move to the two views that together see most of it.</source>
        <translation>Un clic sur le rein gauche dans la coupe axiale en fait la cible. Les caméras vont aux deux vues qui en voient ensemble le plus.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>Drag with the left button in a 3-D view to turn it. The opening follows the kidney; C2 follows C1.</source>
        <translation>Glissez avec le bouton gauche dans une vue 3D pour la tourner. L&apos;ouverture suit le rein&#xa0;; C2 suit C1.</translation>
    </message>
    <message>
        <source>Widen the opening</source>
        <translation>Élargir l&apos;ouverture</translation>
    </message>
    <message>
        <source>The slider Opening in the panel Cutaway sets how far the opening reaches beyond the focus.</source>
        <translation>Le curseur Ouverture du panneau Écorché règle de combien l&apos;ouverture dépasse la cible.</translation>
    </message>
    <message>
        <source>Bring tissue back</source>
        <translation>Ramener du tissu</translation>
    </message>
    <message>
        <source>The brush (P) paints back what the opening removed: here, tissue above the kidney. Ctrl+Z takes a stroke back.</source>
        <translation>Le pinceau (P) ramène ce que l&apos;ouverture a enlevé&#xa0;: ici, du tissu au-dessus du rein. Ctrl+Z annule un trait.</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Le garder</translation>
    </message>
    <message>
        <source>Ctrl+S saves a session with all that you did; Ctrl+E saves a picture, for a slide. F1 opens the user guide.</source>
        <translation>Ctrl+S enregistre une session avec tout ce que vous avez fait&#xa0;; Ctrl+E enregistre une image, pour une diapositive. F1 ouvre le guide de l&apos;utilisateur.</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 sur %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::TransferFunctionEditor</name>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Colour of the selected point</source>
        <translation>Couleur du point choisi</translation>
    </message>
    <message>
        <source>By value</source>
        <translation>Par valeur</translation>
    </message>
    <message>
        <source>Open a transfer function</source>
        <translation>Ouvrir une fonction de transfert</translation>
    </message>
    <message>
        <source>Transfer functions (*.json)</source>
        <translation>Fonctions de transfert (*.json)</translation>
    </message>
    <message>
        <source>What the plot shows and edits</source>
        <translation>Ce que le tracé montre et modifie</translation>
    </message>
    <message>
        <source>Drag points, or the edges, top and inside of a trapezoid. Double-click adds a point; Delete removes it; the wheel enlarges. The key ? lists all.</source>
        <translation>Glissez des points, ou les bords, le haut et l&apos;intérieur d&apos;un trapèze. Un double clic ajoute un point&#xa0;; Suppr l&apos;enlève&#xa0;; la molette agrandit. La touche&#xa0;? liste tout.</translation>
    </message>
    <message>
        <source>Value of the selected point</source>
        <translation>Valeur du point choisi</translation>
    </message>
    <message>
        <source>Opacity of 1 mm at the selected point</source>
        <translation>Opacité de 1 mm au point choisi</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Shows this part of the focus by a function of the values, as the context is shown, in place of one colour and opacity</source>
        <translation>Montre cette partie de la cible par une fonction des valeurs, comme le contexte, au lieu d&apos;une couleur et d&apos;une opacité</translation>
    </message>
    <message>
        <source>From a preset</source>
        <translation>D&apos;un préréglage</translation>
    </message>
    <message>
        <source>Takes the function of a preset for this part of the focus</source>
        <translation>Prend la fonction d&apos;un préréglage pour cette partie de la cible</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>D&apos;un fichier…</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::TransferFunctionPlot</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Transfer function over the histogram</source>
        <translation>Fonction de transfert sur l&apos;histogramme</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Couleur…</translation>
    </message>
    <message>
        <source>Delete the point</source>
        <translation>Supprimer le point</translation>
    </message>
    <message>
        <source>Delete the trapezoid</source>
        <translation>Supprimer le trapèze</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Ajouter un point</translation>
    </message>
    <message>
        <source>Add a trapezoid</source>
        <translation>Ajouter un trapèze</translation>
    </message>
    <message>
        <source>By value</source>
        <translation>Par valeur</translation>
    </message>
    <message>
        <source>Show all values</source>
        <translation>Afficher toutes les valeurs</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Verification</name>
    <message>
        <source>Computed again in double precision: %1 pixels, drawn at random (seed %2). Beyond that: %3. Greatest difference: %4/255.</source>
        <translation>Recalculé en double précision&#xa0;: %1 pixels tirés au hasard (graine %2). Au-delà&#xa0;: %3. Plus grand écart&#xa0;: %4/255.</translation>
    </message>
    <message>
        <source>%1 % of the pixels are within %2/255 of the exact picture: all were computed again.</source>
        <translation>%1 % des pixels sont à moins de %2/255 de l&apos;image exacte&#xa0;: tous ont été recalculés.</translation>
    </message>
    <message>
        <source>At least %1 % of the pixels are within %2/255 of the exact picture, with %3 % confidence.</source>
        <translation>Au moins %1 % des pixels sont à moins de %2/255 de l&apos;image exacte, avec %3 % de confiance.</translation>
    </message>
    <message>
        <source>No 3-D view is on screen that could be verified.</source>
        <translation>Aucune vue 3D à l&apos;écran ne peut être vérifiée.</translation>
    </message>
    <message>
        <source>The picture is verified once it is drawn at full quality.</source>
        <translation>L&apos;image est vérifiée dès qu&apos;elle est dessinée en pleine qualité.</translation>
    </message>
    <message>
        <source>Verify this picture</source>
        <translation>Vérifier cette image</translation>
    </message>
    <message>
        <source>&amp;Save the picture…</source>
        <translation>&amp;Enregistrer l&apos;image…</translation>
    </message>
    <message>
        <source>Save the picture with its certificate</source>
        <translation>Enregistrer l&apos;image avec son certificat</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 écrit</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ViewArea</name>
    <message>
        <source>3-D views are not available here.

%1

The slices work without it.</source>
        <translation>Les vues 3D ne sont pas disponibles ici.

%1

Les coupes fonctionnent sans elles.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ViewCommands</name>
    <message>
        <source>Standard view</source>
        <translation>Vue standard</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>Réinitialiser la vue</translation>
    </message>
    <message>
        <source>Reset views</source>
        <translation>Réinitialiser les vues</translation>
    </message>
    <message>
        <source>Freeze the opening</source>
        <translation>Figer l&apos;ouverture</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::VolumeView</name>
    <message>
        <source>The 3-D views cannot be drawn. %1</source>
        <translation>Les vues 3D ne peuvent pas être dessinées. %1</translation>
    </message>
    <message>
        <source>The first 3-D picture of this study is being made…</source>
        <translation>La première image 3D de cet examen est en cours…</translation>
    </message>
    <message>
        <source>Editing the label; the one before still shows</source>
        <translation>Modification de l&apos;étiquette&#xa0;; la précédente reste affichée</translation>
    </message>
    <message>
        <source>Not yet as asked for: the picture is being prepared</source>
        <translation>Pas encore ce qui est demandé&#xa0;: l&apos;image est en préparation</translation>
    </message>
    <message>
        <source>Waits for the picture</source>
        <translation>Attend l&apos;image</translation>
    </message>
    <message>
        <source>C%1</source>
        <translation>C%1</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>perspective</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>parallèle</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::WaitingBar</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Take back what the pictures do not show yet</source>
        <translation>Retirer ce que les images ne montrent pas encore</translation>
    </message>
    <message>
        <source>Preparing the picture, %1 s</source>
        <translation>Préparation de l&apos;image, %1 s</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::WelcomePage</name>
    <message>
        <source>3-D views are not available here; slices work. %1</source>
        <translation>Les vues 3D ne sont pas disponibles ici&#xa0;; les coupes fonctionnent. %1</translation>
    </message>
    <message>
        <source>No graphics card was found: the processor draws the 3-D views, in smaller pictures while something moves. (%1)</source>
        <translation>Aucune carte graphique trouvée&#xa0;: le processeur dessine les vues 3D, en images plus petites pendant les mouvements. (%1)</translation>
    </message>
    <message>
        <source>The graphics card draws the 3-D views. (%1)</source>
        <translation>La carte graphique dessine les vues 3D. (%1)</translation>
    </message>
    <message>
        <source>Choose a structure in a CT or MR, and the tissue in front of it opens. &lt;b&gt;Not for diagnostic use.&lt;/b&gt;</source>
        <translation>Choisissez une structure dans une TDM ou une IRM, et le tissu devant elle s&apos;ouvre. &lt;b&gt;Ne pas utiliser pour le diagnostic.&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Opened last</source>
        <translation>Ouvert récemment</translation>
    </message>
    <message>
        <source>User guide (F1)</source>
        <translation>Guide de l&apos;utilisateur (F1)</translation>
    </message>
    <message>
        <source>Built-in phantoms</source>
        <translation>Fantômes intégrés</translation>
    </message>
    <message>
        <source>Bodies made of simple shapes, with every structure labelled. Nobody&apos;s data: try everything on them.</source>
        <translation>Des corps de formes simples, dont chaque structure est étiquetée. Les données de personne&#xa0;: essayez tout dessus.</translation>
    </message>
    <message>
        <source>Guided tour</source>
        <translation>Visite guidée</translation>
    </message>
    <message>
        <source>Clicks through the first minute on the torso phantom, and says at each step what it does.</source>
        <translation>Parcourt la première minute sur le fantôme du torse et dit à chaque étape ce qui se passe.</translation>
    </message>
    <message>
        <source>Your own data</source>
        <translation>Vos propres données</translation>
    </message>
    <message>
        <source>Drop a folder of DICOM files, or a NIfTI, NRRD or MetaImage file, anywhere in this window.</source>
        <translation>Déposez un dossier de fichiers DICOM, ou un fichier NIfTI, NRRD ou MetaImage, n&apos;importe où dans cette fenêtre.</translation>
    </message>
    <message>
        <source>Start the tour</source>
        <translation>Commencer la visite</translation>
    </message>
    <message>
        <source>Open a folder…</source>
        <translation>Ouvrir un dossier…</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Ouvrir un fichier…</translation>
    </message>
    <message>
        <source>session</source>
        <translation>session</translation>
    </message>
    <message>
        <source>study</source>
        <translation>examen</translation>
    </message>
    <message>
        <source>%1 %2, name hidden</source>
        <translation>%1 %2, nom masqué</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::WindowLevelDialog</name>
    <message>
        <source>Window and level</source>
        <translation>Fenêtrage</translation>
    </message>
    <message>
        <source>&amp;Invert: low values bright</source>
        <translation>&amp;Inverser&#xa0;: valeurs basses claires</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Largeur</translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation>&amp;Niveau</translation>
    </message>
</context>
</TS>
